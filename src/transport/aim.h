// SPDX-License-Identifier: GPL-3.0-or-later
// Directions of light that mostly leads to what the camera sees, however far away it starts: else
// the few rays from afar that arrive there would stand for very much light.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"
#include "transport/lit_region.h"

namespace candelabra {

class Aim {
public:
    /// `share`: of the directions that lead about the region, from 0 to below 1. None does from a
    /// place within or near the region.
    Aim(const LitRegion&, const Vec3& from, double share);

    /// Returns a unit direction. `own` draws one that is not aimed. u is in [0, 1)^2.
    Vec3 draw(const Vec2& u, FunctionRef<Vec3(const Vec2&)> own) const;
    /// Density of draw() per steradian. `own`: that of the directions that are not aimed.
    double density(const Vec3& direction, double own) const;

private:
    Vec3 offset_;
    double radius_, away_, share_;
};

}  // namespace candelabra
