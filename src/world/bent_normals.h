// SPDX-License-Identifier: GPL-3.0-or-later
// Bent normals: directions in which the light of luminaires leaves their surroundings. A window
// shines into the street and not into its own house, a stone half in a box out of the box. A Shot
// has them, for the light octree. The same for any number of threads.
#pragma once

#include "world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace candelabra {

/// Returns the bent normal of each luminaire (LightBounds::bent_normal): the mean direction of
/// unoccluded light, which is longer the more directed that light is. It is found by rays from the
/// surface. Rays that leave a solid that does not contain the eye count as occluded, and so do
/// those of flat luminaires into their mounting. (Other near surfaces may be there to be lit by the
/// luminaire.) `pixels`: of the picture. Empty if there are fewer than two luminaires, or more than
/// 2^17 and than pixels.
std::vector<Vec3> find_bent_normals(const World&, const std::optional<Vec3>& eye,
                                    std::uint64_t pixels, int threads);

}  // namespace candelabra
