// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the reflection of roads, as CSV. Used by meters of luminance.
#pragma once

#include "meter/road_table.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Reads a table that is empty: angles in the first row, tangents in the first column. A cell of no
/// text is 0, as in the tables of CIE. Returns an error as a sentence, or an empty string.
std::string read_road_table(std::string_view text, RoadTable&);

}  // namespace candelabra
