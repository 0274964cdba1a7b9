// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers that check the value of an option and store it in Options. Called only through the table
// of options (options/option_table.h).
#pragma once

#include "options/options.h"
#include "text/ascii.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// An option as it was given.
struct Given {
    std::string_view argument;  ///< as written, for messages
    bool on = true;             ///< false: `-X`, `Keyword=off`
    std::optional<std::string> value;
    std::string_view where = {};  ///< "scene.ini:3" for an option in a file
};

/// Parses a decimal number that fills the text; returns nothing for anything else.
std::optional<double> number(std::string_view text);

/// Whether an option was given, by its long name, such as "frame-rate".
bool is_given(const Options&, std::string_view word);

/// Parses on, true, yes, 1 and off, false, no, 0, ignoring case.
std::optional<bool> truth(std::string_view text);

/// Returns the option as messages name it, with its place if it has one.
std::string shown(const Given&);

/// Reports an error of an option.
void refuse(const Given&, Diagnostics&, const std::string& rule, const std::string& help = {});

/// The rule of the preview beside tasks.
inline constexpr const char* shown_only =
    "a run shows the preview, or checks, dumps, picks, exports, measures or balances the scene, "
    "one of them only";

/// A setting of the rendering or of the animation that has an option.
struct Setting {
    const ItemInfo* item = nullptr;  ///< null: there is none
    std::size_t field = 0;
    const FieldInfo& info() const { return item->fields[field]; }
};
Setting find_setting(std::string_view name);

namespace store {

/// Stores a number or a switch in the setting with that name. A number after a switch is stored in
/// the setting that follows.
void field(std::string_view name, Options&, const Given&, Diagnostics&);

void scene(Options&, const Given&, Diagnostics&);
void to_file(Options&, const Given&, Diagnostics&);
void type(Options&, const Given&, Diagnostics&);
void bits(Options&, const Given&, Diagnostics&);
void export_mesh(Options&, const Given&, Diagnostics&);
void measure(Options&, const Given&, Diagnostics&);
void light_balance(Options&, const Given&, Diagnostics&);
void until(Options&, const Given&, Diagnostics&);
void declare(Options&, const Given&, Diagnostics&);
void header(Options&, const Given&, Diagnostics&);
void create_ini(Options&, const Given&, Diagnostics&);
/// These mark the option; the reader of options reads the file.
void include_ini(Options&, const Given&, Diagnostics&);
void preset(Options&, const Given&, Diagnostics&);
void clock(Options&, const Given&, Diagnostics&);
void check(Options&, const Given&, Diagnostics&);
void dump(Options&, const Given&, Diagnostics&);
void pick(Options&, const Given&, Diagnostics&);
void help(Options&, const Given&, Diagnostics&);
void version(Options&, const Given&, Diagnostics&);
void completion(Options&, const Given&, Diagnostics&);
void describe(Options&, const Given&, Diagnostics&);
void warn(Options&, const Given&, Diagnostics&);
void warning_level(Options&, const Given&, Diagnostics&);
void gamma(Options&, const Given&, Diagnostics&);
void layers(Options&, const Given&, Diagnostics&);
void frames(Options&, const Given&, Diagnostics&);
void preview(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
