// SPDX-License-Identifier: GPL-3.0-or-later
// Help on options, made from their table: for --help, --describe, the manual and completion.
#pragma once

#include "options/option_table.h"
#include "vocabulary/manual.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Returns a few lines about the purpose and the usage of the program.
std::string short_usage();

/// Returns the syntax of the option in all of its forms, and its meaning.
ManualEntry manual_entry(const OptionRow&);

/// Returns the help up to its first semicolon, full stop or bracket, for lists with one line for
/// each option.
std::string first_clause(const std::string& help);

/// Returns one screen: the usage, the usual options and the names of all groups of options.
std::string short_help();

/// Returns all options that are offered, by group.
std::string long_help();

/// Returns the options as a list, those that are offered in their groups. `offered`: false for
/// POV-Ray's options that have no effect or are refused.
std::string option_manual(ManualForm, bool offered);

/// Returns a JSON array of the options with names, group, type, range, default and effect.
/// `name`: the key of the syntax.
std::string options_as_json(bool offered, std::string_view name);

/// Returns help on an option, or on a group as `film options`; empty for another topic.
std::string option_help(std::string_view topic);

}  // namespace candelabra
