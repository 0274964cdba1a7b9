// SPDX-License-Identifier: GPL-3.0-or-later
// Bent normals: where the light of each luminaire gets out of what it is set into: a window shines
// into the street and not into its own house, a stone half in a box out of it. Called by compile();
// the light octree chooses by it. The same for any number of threads.
#pragma once

#include "world/world.h"

namespace candelabra {

/// Fills in Luminaire::bent_normal: the mean direction in which a luminaire's light gets away, the longer
/// the more of it. It is found by rays from the surface. Those that leave a solid that the eye is
/// not in do not get away, nor do those of flat luminaires into what they are mounted on. (Whatever
/// else is near may be what a luminaire is there to light.) More than 2^17 luminaires are left as
/// they are.
void find_bent_normals(World&, const std::optional<Vec3>& eye, int threads);

}  // namespace candelabra
