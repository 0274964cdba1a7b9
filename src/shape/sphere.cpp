// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere.h"

#include "vocabulary/schema.h"

const ItemInfo Sphere::vocabulary = described<Sphere>([] {
    using F = Field<Sphere>;
    return schema<Sphere>("sphere", "All points at one distance from a centre.",
                          F{"centre", &Sphere::centre, positional, "centre"},
                          F{"radius", &Sphere::radius, positional, "radius", any_sign()});
});

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

/// Part of [low, high] in which a coordinate of the surface lies, when its distance from the centre
/// c is from least to most.
Interval reach(double c, const Interval& distance, double low, double high) {
    const double pad = 4 * ulp * (std::abs(c) + distance.max);
    const Interval left{std::fmax(low, c - distance.max - pad),
                        std::fmin(high, c - distance.min + pad)};
    const Interval right{std::fmax(low, c + distance.min - pad),
                         std::fmin(high, c + distance.max + pad)};
    if (left.min > left.max) return right;
    if (right.min > right.max) return left;
    return {left.min, right.max};
}

}  // namespace

Box bounds(const Sphere& sphere) {
    return {sphere.centre - Vec3(sphere.radius), sphere.centre + Vec3(sphere.radius)};
}

void crossings(const Sphere& sphere, const Ray& ray, Crossings& found) {
    const Vec3& direction = ray.direction;
    const double a = dot(direction, direction);
    const Vec3 offset = ray.origin - sphere.centre;
    double middle = -dot(offset, direction) / a;
    Vec3 closest = offset + middle * direction;
    // Far from the origin of the ray the first projection leaves a remainder along it.
    const double rest = -dot(closest, direction) / a;
    middle += rest;
    closest += rest * direction;
    const double half2 = sphere.radius * sphere.radius - dot(closest, closest);
    if (!(half2 > 0)) return;
    const double half = std::sqrt(half2 / a);
    found.add({middle - half, unit(closest - half * direction), true});
    found.add({middle + half, unit(closest + half * direction), false});
}

bool inside(const Sphere& sphere, const Vec3& point) {
    const Vec3 offset = point - sphere.centre;
    return dot(offset, offset) < sphere.radius * sphere.radius;
}

Box clipped_bounds(const Sphere& sphere, const Box& cell) {
    if (cell.empty()) return {};
    const Vec3 low = cell.low - sphere.centre, high = cell.high - sphere.centre;
    const Vec3 gap = glm::max(glm::max(low, -high), Vec3(0)), far = glm::max(-low, high);
    const Vec3 least = gap * gap, most = far * far;
    const double r2 = sphere.radius * sphere.radius, slack = 8 * ulp * r2;
    Box result;
    for (int axis = 0; axis < 3; ++axis) {
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        // Across the axis the cell reaches from least to most, so along it the surface keeps these
        // distances.
        const double outer2 = r2 + slack - (least[j] + least[k]),
                     inner2 = r2 - slack - (most[j] + most[k]);
        if (outer2 < 0) return {};
        const Interval distance{std::sqrt(std::fmax(inner2, 0)), std::sqrt(outer2)};
        const Interval part = reach(sphere.centre[axis], distance, cell.low[axis], cell.high[axis]);
        if (part.min > part.max) return {};
        result.low[axis] = part.min;
        result.high[axis] = part.max;
    }
    return result;
}

std::string vanishes(const Sphere& sphere) { return sphere.radius == 0 ? "its radius is 0" : ""; }
