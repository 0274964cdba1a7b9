// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere.h"

#include "vocabulary/schema.h"

const ItemInfo Sphere::vocabulary = described<Sphere>([] {
    using F = Field<Sphere>;
    return schema<Sphere>("sphere", "All points at one distance from a centre.",
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

std::string vanishes(const Sphere& sphere) { return sphere.radius == 0 ? "its radius is 0" : ""; }
