// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi's cells of points in a plane: for prisms, tiles, cracks. What the language's
// voronoi_cell() gives.
#pragma once

#include "base/vector.h"

#include <span>
#include <vector>

namespace candelabra {

/// The corners of what is nearer to point number i than to any other, within the rectangle,
/// counterclockwise; empty when nothing is (the point lies outside, or on another one).
std::vector<Vec2> voronoi_cell(std::span<const Vec2> points, std::size_t i, const Vec2& low,
                               const Vec2& high);

}  // namespace candelabra
