// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all switches, keywords and long options. The command line is parsed with it; help,
// manual, completion, the identity of a picture and the command that it records are made from it.
// POV-Ray switches that are not supported have rows, too.
#pragma once

#include "options/option_row.h"

#include <span>
#include <string_view>

namespace candelabra {

std::span<const OptionRow> option_table();

/// The row with that long name, or null.
const OptionRow* find_option(std::string_view long_name);

}  // namespace candelabra
