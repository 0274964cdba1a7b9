// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_rectangle.h"

#include "base/ray.h"

#include <cmath>

namespace candelabra {

namespace {

/// Ratio of squared diagonal to squared distance above which it is sampled by solid angle; below,
/// sampling by area is as good.
constexpr double large = 0.1;
/// Fraction of a side that is drawn below the horizon, because of rounding.
constexpr double at_horizon = 1e-9;
/// Sine that is added to the elevation, so that what is seen along the surface has a weight too: it
/// may light surfaces that are not matt.
constexpr double min_height = 0.05;

/// The part of a side that may be above the horizon, as fractions of the side; the maximum height
/// at a fraction is height + fraction * rise.
Interval above_horizon(double height, double rise) {
    if (rise == 0) return height > 0 ? Interval{0, 1} : Interval{1, 0};
    const double level = -height / rise;
    if (rise > 0) return {std::fmax(level - at_horizon, 0), 1};
    return {0, std::fmin(level + at_horizon, 1)};
}

}  // namespace

SeenRectangle::SeenRectangle(const Vec3& corner, const Vec3& side1, const Vec3& side2,
                             const Vec3& from, const Vec3* normal)
    : corner_(corner), side1_(side1), side2_(side2), from_(from) {
    if (normal && !rise_above(*normal)) return;
    // Solid angle: exact, or as seen from the middle.
    const Vec3 offset = corner_ + 0.5 * (side1_ + side2_) - from_;
    const double distance2 = dot(offset, offset), distance = std::sqrt(distance2);
    const double sides2 = dot(side1_, side1_) + dot(side2_, side2_);
    const bool is_large = sides2 > large * distance2;
    weight_ = std::abs(dot(cross(side1_, side2_), offset)) / (distance2 * distance);
    if (is_large && std::abs(dot(side1_, side2_)) < 1e-12 * sides2) {
        const SphericalRectangle near(from_, corner_, side1_, side2_);
        if (near.solid_angle() > 1e-3) {
            weight_ = near.solid_angle();
            near_ = near;
        }
    }
    if (normal)
        weight_ *= min_height +
                   (is_large ? height(*normal) : std::fmax(dot(*normal, offset) / distance, 0));
}

/// Cuts off the parts below the horizon; returns false if all of it is below.
bool SeenRectangle::rise_above(const Vec3& normal) {
    const double height = dot(normal, corner_ - from_), rise1 = dot(normal, side1_),
                 rise2 = dot(normal, side2_);
    const Interval part1 = above_horizon(height + std::fmax(rise2, 0), rise1),
                   part2 = above_horizon(height + std::fmax(rise1, 0), rise2);
    if (!(part1.min < part1.max && part2.min < part2.max)) return false;
    corner_ += part1.min * side1_ + part2.min * side2_;
    side1_ *= part1.max - part1.min;
    side2_ *= part2.max - part2.min;
    return true;
}

/// Mean sine of the corners' elevation; corners below the horizon count as 0.
double SeenRectangle::height(const Vec3& normal) const {
    double sum = 0;
    for (const Vec3& end : {corner_, corner_ + side1_, corner_ + side2_, corner_ + side1_ + side2_})
        sum += std::fmax(dot(normal, unit(end - from_)), 0);
    return sum / 4;
}

double SeenRectangle::density(const Vec3& direction, double distance) const {
    if (!(weight_ > 0)) return 0;
    if (near_) return 1 / near_->solid_angle();
    const double seen = std::abs(dot(cross(side1_, side2_), direction));
    return seen > 0 ? distance * distance / seen : 0;
}

std::optional<LightPoint> SeenRectangle::draw(const Vec2& u) const {
    const Vec3 position = near_ ? near_->sample(u) : corner_ + u.x * side1_ + u.y * side2_;
    const Vec3 offset = position - from_;
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    const Vec3 direction = offset / distance;
    const double found = density(direction, distance);
    if (!(found > 0)) return {};
    return LightPoint{position, direction, distance, found};
}

}  // namespace candelabra
