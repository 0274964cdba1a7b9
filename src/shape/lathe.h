// SPDX-License-Identifier: GPL-3.0-or-later
// A curve turned around the y axis. Rays are tested against the BuiltLathe.
#pragma once

#include "base/ray.h"
#include "shape/curve.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A curve of points <radius, height>, turned around the y axis. It need not be closed: the inside
/// lies between the curve and the axis.
struct Lathe {
    int spline = linear_curve;
    std::vector<Vec2> points;

    static const ItemInfo vocabulary;
};

struct BuiltLathe {
    struct Part {
        CurvePiece piece;
        std::size_t factors;      ///< of the piece, without trailing zeros
        Interval radii, heights;  ///< ranges over the piece, slightly enlarged
    };
    std::vector<Part> parts;
    Box bounds;
    bool outside_right = true;  ///< of the curve's direction, seen with the axis to the left
};

BuiltLathe build(const Lathe&);
/// Error that the ranges of single fields do not exclude (too few points), as a sentence; empty
/// when there is none.
std::string problem(const Lathe&);

Box bounds(const BuiltLathe&);
void crossings(const BuiltLathe&, const Ray&, Crossings&);
bool inside(const BuiltLathe&, const Vec3&);

}  // namespace candelabra
