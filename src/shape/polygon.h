// SPDX-License-Identifier: GPL-3.0-or-later
// A flat polygon with holes. It has no inside. Rays are tested against the BuiltPolygon.
#pragma once

#include "base/ray.h"
#include "shape/outline.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <vector>

namespace candelabra {

/// Loops of corners in one plane: a loop ends where it returns to its first corner. By the even-odd
/// rule, points within an even number of loops are in holes.
struct Polygon {
    std::vector<Vec3> points;

    static const ItemInfo vocabulary;
};

/// A corner and the sides from it.
struct FlatRectangle {
    Vec3 corner, side1, side2;
};

/// Whether the sides of a parallelogram are at right angles, but for rounding.
bool at_right_angles(const Vec3& side1, const Vec3& side2);

struct BuiltPolygon {
    Vec3 origin = Vec3(0), normal = Vec3(0, 0, 1);
    Vec3 right = Vec3(1, 0, 0), up = Vec3(0, 1, 0);  ///< axes of the outline's plane
    Outline outline;
    Box bounds;
    std::optional<FlatRectangle> rectangle = {};  ///< if the polygon is one
};

BuiltPolygon build(const Polygon&);
/// Error that the ranges of single fields do not exclude (too few corners, corners not in one
/// plane), as a sentence; empty when there is none.
std::string problem(const Polygon&);

Box bounds(const BuiltPolygon&);
void crossings(const BuiltPolygon&, const Ray&, Crossings&);
bool inside(const BuiltPolygon&, const Vec3&);

}  // namespace candelabra
