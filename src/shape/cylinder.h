// SPDX-License-Identifier: GPL-3.0-or-later
// A right circular cylinder between two points.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// A cylinder with flat ends, or a tube without them.
struct Cylinder {
    Vec3 base = Vec3(0);
    Vec3 cap = Vec3(0, 1, 0);
    double radius = 1;
    bool open = false;

    static consteval auto vocabulary();
};

consteval auto Cylinder::vocabulary() {
    using F = Field<Cylinder>;
    return schema<Cylinder>("cylinder", "A cylinder with flat ends.",
                            F{"base", &Cylinder::base, positional, "centre of one end"},
                            F{"cap", &Cylinder::cap, positional, "centre of the other end"},
                            F{"radius", &Cylinder::radius, positional, "radius", above(0)},
                            F{"open", &Cylinder::open, flag, "leaves the ends out"});
}

Box bounds(const Cylinder&);
void crossings(const Cylinder&, const Ray&, Crossings&);
bool inside(const Cylinder&, const Vec3&);
/// What is wrong beyond the ranges of single fields (ends that coincide), as a sentence; empty when
/// nothing is.
std::string problem(const Cylinder&);
