// SPDX-License-Identifier: GPL-3.0-or-later
// A superellipsoid: between box, cylinder, sphere and octahedron, within the cube from -1 to 1.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// The points with ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2) <= 1 for exponents <e, n>.
struct Superellipsoid {
    Vec2 exponents = Vec2(0.5, 0.5);

    static consteval auto vocabulary();
};

consteval auto Superellipsoid::vocabulary() {
    using F = Field<Superellipsoid>;
    return schema<Superellipsoid>(
        "superellipsoid", "A solid between box, cylinder, sphere and octahedron.",
        F{"exponents", &Superellipsoid::exponents, positional,
          "<e, n>: 1 is round, towards 0 square, 2 is straight, above it pinched", above(0)});
}

Box bounds(const Superellipsoid&);
void crossings(const Superellipsoid&, const Ray&, Crossings&);
bool inside(const Superellipsoid&, const Vec3&);
