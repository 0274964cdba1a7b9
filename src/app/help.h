// SPDX-License-Identifier: GPL-3.0-or-later
// What --help, --version and --describe say, made from the tables of options and items.
#pragma once

#include "app/option_table.h"
#include "text/diagnostic.h"
#include "vocabulary/manual.h"

#include <string>
#include <string_view>

namespace candelabra {

std::string version_text();

/// A few lines: what the program does and how it is called.
std::string short_usage();

/// How the option is written, and what it means.
ManualEntry manual_entry(const OptionRow&);

/// The options, or what there is to say about a topic: an option, an item, a group of items, a file
/// of the library or a macro in it. Reports unknown topics. `library`: its folder, or "".
std::string help_text(std::string_view topic, const std::string& library, Diagnostics&);

/// Tables for the manual and for editors. Part: items, functions, glossary, library (all of it),
/// macros (of the library, those for scenes), options, compatibility, missing, words, warnings,
/// textmate (a grammar), or nothing for items (in JSON: for all).
std::string description(std::string_view part, ManualForm, const std::string& library,
                        Diagnostics&);

}  // namespace candelabra
