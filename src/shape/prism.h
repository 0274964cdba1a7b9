// SPDX-License-Identifier: GPL-3.0-or-later
// An outline in the xz plane, swept along y. Rays ask the BuiltPrism; text is made of such, too.
#pragma once

#include "base/ray.h"
#include "shape/outline.h"
#include "vocabulary/schema.h"

enum SweepKind : int {
    linear_sweep,  ///< the same outline at all heights
    conic_sweep,   ///< the outline grows with y: a point at 0, its own size at 1
};

/// An outline swept from one height to another.
struct Prism {
    int sweep = linear_sweep;
    int spline = linear_curve;
    double height1 = 0;
    double height2 = 1;
    std::vector<Vec2> points;  ///< <x, z>
    bool open = false;

    static consteval auto vocabulary();
};

consteval auto Prism::vocabulary() {
    using F = Field<Prism>;
    return schema<Prism>(
        "prism", "Closed curves in the xz plane, swept along y.",
        F{"height1", &Prism::height1, positional, "height of one end"},
        F{"height2", &Prism::height2, positional, "height of the other"},
        F{"points", &Prism::points, counted, "<x, z>, loop after loop; each ends at its start"},
        chooses("linear_sweep", &Prism::sweep, linear_sweep, "keeps the outline's size"),
        chooses("conic_sweep", &Prism::sweep, conic_sweep, "scales the outline by y: a pyramid"),
        chooses("linear_spline", &Prism::spline, linear_curve, "straight between the points"),
        chooses("quadratic_spline", &Prism::spline, quadratic_curve,
                "smooth; the first point of a loop only shapes its curve"),
        chooses("cubic_spline", &Prism::spline, cubic_curve,
                "smooth; the first and last point of a loop only shape its curve"),
        chooses("bezier_spline", &Prism::spline, bezier_curve,
                "each four points are a Bezier curve"),
        F{"open", &Prism::open, flag, "leaves the ends out"});
}

struct BuiltPrism {
    Outline outline;  ///< z as y
    double bottom = 0, top = 1;
    bool conic = false, open = false;
};

BuiltPrism build(const Prism&);
/// What is wrong beyond the ranges of single fields (too few points, a loop that stays open ...),
/// as a sentence; empty when nothing is.
std::string problem(const Prism&);

Box bounds(const BuiltPrism&);
void crossings(const BuiltPrism&, const Ray&, Crossings&);
bool inside(const BuiltPrism&, const Vec3&);
