// SPDX-License-Identifier: GPL-3.0-or-later
// A right circular cone or frustum between two points.
#pragma once

#include "base/ray.h"
#include "vocabulary/schema.h"

/// A cone: its radius goes linearly from one end to the other.
struct Cone {
    Vec3 base = Vec3(0);
    double base_radius = 1;
    Vec3 cap = Vec3(0, 1, 0);
    double cap_radius = 0;
    bool open = false;

    static consteval auto vocabulary();
};

consteval auto Cone::vocabulary() {
    using F = Field<Cone>;
    return schema<Cone>(
        "cone", "A cone or a frustum with flat ends.",
        F{"base", &Cone::base, positional, "centre of one end"},
        F{"base_radius", &Cone::base_radius, positional, "radius at that end", at_least(0)},
        F{"cap", &Cone::cap, positional, "centre of the other end"},
        F{"cap_radius", &Cone::cap_radius, positional, "radius there", at_least(0)},
        F{"open", &Cone::open, flag, "leaves the ends out"});
}

Box bounds(const Cone&);
void crossings(const Cone&, const Ray&, Crossings&);
bool inside(const Cone&, const Vec3&);
/// What is wrong beyond the ranges of single fields (ends that coincide, no radius), as a sentence;
/// empty when nothing is.
std::string problem(const Cone&);
