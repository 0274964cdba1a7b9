// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a glowing rectangle or parallelogram that may light a point, and points on it. Used
// for rectangles and for the faces of boxes.
#pragma once

#include "luminaire/luminaire.h"
#include "luminaire/spherical_rectangle.h"

#include <optional>

namespace candelabra {

class SeenRectangle {
public:
    SeenRectangle() = default;
    /// `normal`: unit normal of the receiver at `from`, below whose horizon no light counts; null:
    /// all directions count. The side that is seen does not matter.
    SeenRectangle(const Vec3& corner, const Vec3& side1, const Vec3& side2, const Vec3& from,
                  const Vec3* normal);

    /// Roughly the irradiance from it; 0 if all of it is below the horizon.
    double weight() const { return weight_; }
    /// Returns a point that may be above the horizon; u is in [0, 1)^2. Returns nothing if rounding
    /// puts the receiver in the plane. Precondition: the weight is above 0.
    std::optional<LightPoint> draw(const Vec2& u) const;
    /// Density per steradian of the point in the direction of the given unit vector, at this
    /// distance; 0 where no point is drawn.
    double density(const Vec3& direction, double distance) const;

private:
    bool rise_above(const Vec3& normal);
    double height(const Vec3& normal) const;

    /// In world space; the part that is drawn from.
    Vec3 corner_ = Vec3(0), side1_ = Vec3(0), side2_ = Vec3(0);
    Vec3 from_ = Vec3(0);
    std::optional<SphericalRectangle> near_;  ///< if it fills much of the view
    double weight_ = 0;
};

}  // namespace candelabra
