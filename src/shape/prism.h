// SPDX-License-Identifier: GPL-3.0-or-later
// An outline in the xz plane, swept along y. Rays are tested against the BuiltPrism; text is made
// of prisms, too.
#pragma once

#include "base/ray.h"
#include "shape/outline.h"
#include "vocabulary/item_info.h"

namespace candelabra {

enum SweepKind : int {
    linear_sweep,  ///< the same outline at all heights
    conic_sweep,   ///< the outline scales with y: a point at 0, full size at 1
};

/// An outline swept from one height to another.
struct Prism {
    int sweep = linear_sweep;
    int spline = linear_curve;
    double height1 = 0;
    double height2 = 1;
    std::vector<Vec2> points;  ///< <x, z>
    bool open = false;

    static const ItemInfo vocabulary;
};

struct BuiltPrism {
    Outline outline;  ///< in the xz plane, with z as y
    double bottom = 0, top = 1;
    bool conic = false, open = false;
};

BuiltPrism build(const Prism&);
/// Error that the ranges of single fields do not exclude (too few points, an open loop ...), as a
/// sentence; empty when there is none.
std::string problem(const Prism&);

Box bounds(const BuiltPrism&);
void crossings(const BuiltPrism&, const Ray&, Crossings&);
bool inside(const BuiltPrism&, const Vec3&);

}  // namespace candelabra
