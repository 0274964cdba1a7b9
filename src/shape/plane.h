// SPDX-License-Identifier: GPL-3.0-or-later
// An unbounded plane with a half space behind it.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// The half space behind a plane.
struct Plane {
    Vec3 normal = Vec3(0, 1, 0);
    double distance = 0;

    static consteval auto vocabulary();
};

consteval auto Plane::vocabulary() {
    using F = Field<Plane>;
    return schema<Plane>("plane", "An unbounded plane; its inside is the half space behind it.",
                         F{"normal", &Plane::normal, positional,
                           "direction away from the inside, of any length but 0"},
                         F{"distance", &Plane::distance, positional,
                           "distance from the origin along the unit normal"});
}

Box bounds(const Plane&);
void crossings(const Plane&, const Ray&, Crossings&);
bool inside(const Plane&, const Vec3&);
/// Where a half space along an axis ends.
Box inside_bounds(const Plane&);
/// What is wrong beyond the ranges of single fields (normal without a direction), as a sentence;
/// empty when nothing is.
std::string problem(const Plane&);
