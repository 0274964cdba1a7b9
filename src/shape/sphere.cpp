// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Sphere::vocabulary = described<Sphere>([] {
    using F = Field<Sphere>;
    return schema<Sphere>("sphere",
                          {"All points at one distance from a centre.", "sphere { y, 1 }"},
                          F{"centre", &Sphere::centre, positional, "centre"},
                          F{"radius", &Sphere::radius, positional, "radius", any_sign()});
});

Box bounds(const Sphere& sphere) {
    return {sphere.centre - Vec3(sphere.radius), sphere.centre + Vec3(sphere.radius)};
}

void crossings(const Sphere& sphere, const Ray& ray, Crossings& found) {
    const Vec3& direction = ray.direction;
    const double a = dot(direction, direction);
    const Vec3 offset = ray.origin - sphere.centre;
    double middle = -dot(offset, direction) / a;
    Vec3 closest = offset + middle * direction;
    // For a distant ray origin, the first projection leaves a remainder along the ray.
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

std::string vanishes(const Sphere& sphere) { return sphere.radius == 0 ? "its radius is 0" : ""; }

Box clipped_bounds(const Sphere& sphere, const Box& cell) {
    const double radius = std::abs(sphere.radius), radius2 = radius * radius;
    const Vec3 low = cell.low - sphere.centre, high = cell.high - sphere.centre;
    // Distances from the centre along each axis.
    const Vec3 gap = glm::max(glm::max(low, -high), Vec3(0)), far = glm::max(-low, high);
    const Vec3 near2 = gap * gap, far2 = far * far;
    const double slack = 0x1p-48 * radius * (radius + max_abs_component(sphere.centre));
    const double nearest = near2.x + near2.y + near2.z, farthest = far2.x + far2.y + far2.z;
    if (nearest > radius2 + slack || farthest < radius2 - slack) return {};
    Box part = cell;
    for (int axis = 0; axis < 3; ++axis) {
        // Maximum and minimum distance of the surface from the centre along the axis.
        const double most2 = radius2 - (nearest - near2[axis]) + slack;
        const double least2 = radius2 - (farthest - far2[axis]) - slack;
        const double most = most2 > 0 ? std::sqrt(most2) : 0;
        const double least = least2 > 0 ? std::sqrt(least2) : 0;
        const bool above = low[axis] > -least, below = high[axis] < least;
        part.low[axis] = std::max(part.low[axis], sphere.centre[axis] + (above ? least : -most));
        part.high[axis] = std::min(part.high[axis], sphere.centre[axis] + (below ? -least : most));
    }
    return part;
}

}  // namespace candelabra
