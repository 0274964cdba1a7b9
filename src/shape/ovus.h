// SPDX-License-Identifier: GPL-3.0-or-later
// An egg: two spheres on the y axis, joined by an arc.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// A sphere around the origin, one around a point above it at the distance of the first one's
/// radius, and the smooth solid of revolution between them. With a top of twice the bottom's radius
/// or more, only the sphere at the top is left, as in POV-Ray.
struct Ovus {
    double bottom_radius = 1;
    double top_radius = 0.5;

    static consteval auto vocabulary();
};

consteval auto Ovus::vocabulary() {
    using F = Field<Ovus>;
    return schema<Ovus>(
        "ovus", "An egg.",
        F{"bottom_radius", &Ovus::bottom_radius, positional,
          "radius of the sphere around the origin, and height of the other's centre", above(0)},
        F{"top_radius", &Ovus::top_radius, positional, "radius of the sphere at the top",
          above(0)});
}

Box bounds(const Ovus&);
void crossings(const Ovus&, const Ray&, Crossings&);
bool inside(const Ovus&, const Vec3&);
