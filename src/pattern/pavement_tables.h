// SPDX-License-Identifier: GPL-3.0-or-later
// The borders of all pavements: edges of a lattice, which repeat. Used by pavement.cpp.
#pragma once

#include <span>
#include <string_view>

namespace candelabra {

/// Borders of one pavement. The lattice of squares has edges (1, 0) and (0, 1) at each vertex; that
/// of triangles and hexagons has edges at 0, 60 and 120 degrees. A hexagon is six triangles.
struct BorderTable {
    int width;  ///< vertices of a row, after which the row repeats
    int shift;  ///< the rows repeat, moved by this number of vertices
    /// A digit for each vertex, row by row. It is the sum of 1, 2 and 4 for the first, second and
    /// third edge that is a border.
    std::string_view borders;

    int rows() const { return static_cast<int>(borders.size()) / width; }
};

/// Returns the tables of polygons with this number of sides, by number of tiles and then by
/// pattern; empty: there are none.
std::span<const BorderTable> border_tables(int sides);

}  // namespace candelabra
