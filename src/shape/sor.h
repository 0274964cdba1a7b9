// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of revolution whose squared radius is a smooth function of the height. Rays are tested
// against the BuiltSor.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// Radii at heights, turned around the y axis. The first and the last point only shape the curve.
struct Sor {
    std::vector<Vec2> points;
    bool open = false;

    static const ItemInfo vocabulary;
};

struct BuiltSor {
    /// radius^2 = factors[0] + factors[1] h + factors[2] h^2 + factors[3] h^3 at the height h above
    /// low, up to high.
    struct Part {
        double low, high;
        std::array<double, 4> factors;
        double low2, high2;  ///< squared radii at both ends
        double reach2;       ///< maximum squared radius
    };
    std::vector<Part> parts;
    Box bounds;
    bool open = false;
};

/// The squared radius r^2 interpolates the points. Its slope at a point is 2 r r', where r' is the
/// slope of the line between the neighbours' radii.
BuiltSor build(const Sor&);
/// Error that the ranges of single fields do not exclude (too few points, heights out of order
/// ...), as a sentence; empty when there is none.
std::string problem(const Sor&);

Box bounds(const BuiltSor&);
void crossings(const BuiltSor&, const Ray&, Crossings&);
bool inside(const BuiltSor&, const Vec3&);

}  // namespace candelabra
