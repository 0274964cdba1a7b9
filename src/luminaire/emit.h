// SPDX-License-Identifier: GPL-3.0-or-later
// A ray that leaves a surface which is as bright in all directions; used by the emitters that draw
// points of their area.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// From a point of a surface that was drawn with that density per area: in proportion to the cosine
/// to the normal, on its side, or on both when `both_sides` is set. The normal is a unit vector.
EmittedRay emitted_ray(const Vec3& position, const Vec3& normal, double per_area, Vec2 direction,
                       bool both_sides);

}  // namespace candelabra
