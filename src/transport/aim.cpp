// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/aim.h"

namespace candelabra {

namespace {

/// Distance from the middle of a region, in radii of the region, from which on directions are aimed
/// at it.
constexpr double aimed_from = 1.25;

}  // namespace

Aim::Aim(const LitRegion& region, const Vec3& from, double share)
    : offset_(region.centre - from),
      radius_(region.radius),
      away_(length(offset_)),
      share_(away_ > aimed_from * radius_ ? share : 0) {}

Vec3 Aim::draw(const Vec2& u, FunctionRef<Vec3(const Vec2&)> own) const {
    const double not_aimed = 1 - share_;
    if (u.x < not_aimed) return own({u.x / not_aimed, u.y});
    return unit(offset_ +
                point_about_disc(offset_ / away_, radius_, {(u.x - not_aimed) / share_, u.y}));
}

double Aim::density(const Vec3& direction, double own) const {
    if (share_ == 0) return own;
    const double cosine = dot(direction, offset_) / away_;
    if (!(cosine > 0)) return (1 - share_) * own;
    const double far = away_ / cosine, aside = length(far * direction - offset_);
    return (1 - share_) * own + share_ * far * far / (cosine * area_about_disc(aside, radius_));
}

}  // namespace candelabra
