// SPDX-License-Identifier: GPL-3.0-or-later
// Bent normals: directions in which the light of luminaires leaves their surroundings. A window
// shines into the street and not into its own house, a stone half in a box out of the box. Called
// by compile(); the light octree uses them. The same for any number of threads.
#pragma once

#include "world/world.h"

namespace candelabra {

/// Sets Luminaire::bent_normal: the mean direction of unoccluded light, which is longer the more
/// directed that light is. It is found by rays from the surface. Rays that leave a solid that does
/// not contain the eye count as occluded, and so do those of flat luminaires into their mounting.
/// (Other near surfaces may be there to be lit by the luminaire.) More than 2^17 luminaires remain
/// unchanged.
void find_bent_normals(World&, const std::optional<Vec3>& eye, int threads);

}  // namespace candelabra
