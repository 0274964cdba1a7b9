// SPDX-License-Identifier: GPL-3.0-or-later
// A box along the axes. (The class is Cuboid because base/box.h has Box for bounds.)
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// A solid between two corners, its faces along the axes.
struct Cuboid {
    Vec3 corner1 = Vec3(0);
    Vec3 corner2 = Vec3(1);

    static consteval auto vocabulary();
};

consteval auto Cuboid::vocabulary() {
    using F = Field<Cuboid>;
    return schema<Cuboid>(
        "box", "A solid between two opposite corners, its faces along the axes.",
        F{"corner1", &Cuboid::corner1, positional, "one corner"},
        F{"corner2", &Cuboid::corner2, positional, "the opposite corner, in any order"});
}

Box bounds(const Cuboid&);
void crossings(const Cuboid&, const Ray&, Crossings&);
bool inside(const Cuboid&, const Vec3&);
