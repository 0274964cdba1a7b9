// SPDX-License-Identifier: GPL-3.0-or-later
// The normals of what a camera sees, in few bytes.
#pragma once

#include <cstdint>
#include <vector>

namespace candelabra {

struct Shot;

/// Returns x, y and z of the mean normal of the first surfaces in each pixel, row by row, in 1/127;
/// 0 where there is none. Normals are shading normals, towards the viewer.
std::vector<std::int8_t> seen_normals(const Shot&, int width, int height, int threads);

}  // namespace candelabra
