// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle as seen from a point, sampled uniformly in solid angle (Urena, Fajardo and King, "An
// Area-Preserving Parametrization for Spherical Rectangles", 2013). Used for the faces of boxes.
#pragma once

#include "base/vector.h"

namespace candelabra {

class SphericalRectangle {
public:
    /// The sides must be at right angles, and `from` must not be in the rectangle's plane.
    SphericalRectangle(const Vec3& from, const Vec3& corner, const Vec3& side1, const Vec3& side2);

    /// In steradians. Loses digits far below 0.001; 0 if it cannot be computed.
    double solid_angle() const { return solid_angle_; }
    /// Returns the point for u in [0, 1)^2. Precondition: the solid angle is above 0.
    Vec3 sample(const Vec2& u) const;

private:
    Vec3 from_, x_, y_, z_;
    double x0_, x1_, y0_, y1_, z0_;
    double b0_, b1_, k_, solid_angle_;
};

}  // namespace candelabra
