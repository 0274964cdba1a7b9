// SPDX-License-Identifier: GPL-3.0-or-later
// A torus: the surface of a tube that is bent to a ring around the y axis.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// A ring around the y axis. A tube wider than the ring passes through itself: all of its surface
/// is met, also the part within.
struct Torus {
    double major = 1;
    double minor = 0.25;

    static consteval auto vocabulary();
};

consteval auto Torus::vocabulary() {
    using F = Field<Torus>;
    return schema<Torus>(
        "torus", "A ring around the y axis.",
        F{"major", &Torus::major, positional, "radius of the ring's centre line", at_least(0)},
        F{"minor", &Torus::minor, positional, "radius of the tube", above(0)});
}

Box bounds(const Torus&);
void crossings(const Torus&, const Ray&, Crossings&);
bool inside(const Torus&, const Vec3&);
