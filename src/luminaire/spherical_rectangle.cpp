// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/spherical_rectangle.h"

#include "base/elementary.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

double angle_between(const Vec3& a, const Vec3& b) {
    return math::acos(std::clamp(-dot(a, b), -1.0, 1.0));
}

}  // namespace

SphericalRectangle::SphericalRectangle(const Vec3& from, const Vec3& corner, const Vec3& side1,
                                       const Vec3& side2)
    : from_(from), x_(unit(side1)), y_(unit(side2)), z_(cross(x_, y_)) {
    const Vec3 offset = corner - from;
    z0_ = dot(offset, z_);
    if (z0_ > 0) {
        z_ = -z_;
        z0_ = -z0_;
    }
    x0_ = dot(offset, x_);
    y0_ = dot(offset, y_);
    x1_ = x0_ + length(side1);
    y1_ = y0_ + length(side2);
    // Normals of the planes through the point and each edge, and the angles between them.
    const Vec3 v00(x0_, y0_, z0_), v01(x0_, y1_, z0_), v10(x1_, y0_, z0_), v11(x1_, y1_, z0_);
    const Vec3 n0 = unit(cross(v00, v10)), n1 = unit(cross(v10, v11)), n2 = unit(cross(v11, v01)),
               n3 = unit(cross(v01, v00));
    const double g0 = angle_between(n0, n1), g1 = angle_between(n1, n2), g2 = angle_between(n2, n3),
                 g3 = angle_between(n3, n0);
    b0_ = n0.z;
    b1_ = n2.z;
    k_ = 2 * std::numbers::pi - g2 - g3;
    const double sum = g0 + g1 - k_;
    solid_angle_ = sum > 0 && z0_ < 0 ? sum : 0;
}

Vec3 SphericalRectangle::sample(const Vec2& u) const {
    const double turned = u.x * solid_angle_ + k_;
    const double f = (math::cos(turned) * b0_ - b1_) / math::sin(turned);
    const double c = std::clamp(std::copysign(1 / std::sqrt(f * f + b0_ * b0_), f), -1.0, 1.0);
    const double x = std::clamp(-c * z0_ / std::sqrt(std::fmax(1 - c * c, 1e-300)), x0_, x1_);
    const double d2 = x * x + z0_ * z0_;
    const double h0 = y0_ / std::sqrt(d2 + y0_ * y0_), h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
    const double h = h0 + u.y * (h1 - h0), below = 1 - h * h;
    const double y = below > 1e-14 ? std::clamp(h * std::sqrt(d2 / below), y0_, y1_) : y1_;
    return from_ + x * x_ + y * y_ + z0_ * z_;
}

}  // namespace candelabra
