// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi cells of points in the plane, for prisms, tiles and cracks. Result of the language's
// voronoi_cell().
#pragma once

#include "base/vector.h"

#include <cstddef>
#include <span>
#include <vector>

namespace candelabra {

/// The corners of the region within the rectangle that is nearer to point number i than to any
/// other, counterclockwise; empty when there is none (the point lies outside, or on another one).
std::vector<Vec2> voronoi_cell(std::span<const Vec2> points, std::size_t i, const Vec2& low,
                               const Vec2& high);

}  // namespace candelabra
