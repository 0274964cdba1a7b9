// SPDX-License-Identifier: GPL-3.0-or-later
// The output of --help and --describe, made from the tables of options and items.
#pragma once

#include "text/diagnostic.h"
#include "vocabulary/manual.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Returns the usual options, or help on a topic: all, an option, a group of options, an item, a
/// group of items, a file of the library or a macro in it. Reports unknown topics. `library`: its
/// folder, or "".
std::string help_text(std::string_view topic, const std::string& library, Diagnostics&);

/// Returns tables for the manual and for editors. `part`: items, functions, glossary, library (all
/// of it), macros (of the library, those for scenes), options, compatibility, missing, words,
/// warnings, textmate (a grammar), or empty for items (in JSON: for all).
std::string description(std::string_view part, ManualForm, const std::string& library,
                        Diagnostics&);

}  // namespace candelabra
