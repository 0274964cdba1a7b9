// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the value of an option: a check and a place in Options. The table of options
// (app/option_table.h) names these functions; nothing else calls them.
#pragma once

#include "app/options.h"
#include "text/ascii.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// An option as it was met on the command line.
struct Given {
    std::string_view argument;  ///< as it was written, for messages
    bool on = true;             ///< `-X`, `Keyword=off`: false
    std::optional<std::string> value;
    std::string_view where = {};  ///< "scene.ini:3", of an option in a file
};

/// A decimal number, all of the text; nothing for anything else.
std::optional<double> number(std::string_view text);

/// on, true, yes, 1 and off, false, no, 0, in any case of letters.
std::optional<bool> truth(std::string_view text);

/// The option as messages name it, with its place when it has one.
std::string shown(const Given&);

/// Reports what is wrong with an option.
void refuse(const Given&, Diagnostics&, const std::string& rule, const std::string& help = {});

/// A setting that has an option: of the rendering or of the animation.
struct Setting {
    const ItemInfo* item = nullptr;  ///< null: there is none
    std::size_t field = 0;
    const FieldInfo& info() const { return item->fields[field]; }
};
Setting find_setting(std::string_view name);

namespace store {

/// A number, or on and off, into the setting with that name. A number behind a switch goes into the
/// setting after it.
void field(std::string_view name, Options&, const Given&, Diagnostics&);

void scene(Options&, const Given&, Diagnostics&);
void output(Options&, const Given&, Diagnostics&);
void to_file(Options&, const Given&, Diagnostics&);
void type(Options&, const Given&, Diagnostics&);
void bits(Options&, const Given&, Diagnostics&);
void library(Options&, const Given&, Diagnostics&);
void allow_read(Options&, const Given&, Diagnostics&);
void allow_write(Options&, const Given&, Diagnostics&);
void export_mesh(Options&, const Given&, Diagnostics&);
void export_object(Options&, const Given&, Diagnostics&);
void declare(Options&, const Given&, Diagnostics&);
void header(Options&, const Given&, Diagnostics&);
void language_version(Options&, const Given&, Diagnostics&);
void movie(Options&, const Given&, Diagnostics&);
void frame_rate(Options&, const Given&, Diagnostics&);
void create_ini(Options&, const Given&, Diagnostics&);
void clock(Options&, const Given&, Diagnostics&);
void verbose(Options&, const Given&, Diagnostics&);
void check(Options&, const Given&, Diagnostics&);
void dump(Options&, const Given&, Diagnostics&);
void light_report(Options&, const Given&, Diagnostics&);
void stats(Options&, const Given&, Diagnostics&);
void help(Options&, const Given&, Diagnostics&);
void version(Options&, const Given&, Diagnostics&);
void completion(Options&, const Given&, Diagnostics&);
void describe(Options&, const Given&, Diagnostics&);
void diagnostics(Options&, const Given&, Diagnostics&);
void warn(Options&, const Given&, Diagnostics&);
void warning_level(Options&, const Given&, Diagnostics&);
void gamma(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
