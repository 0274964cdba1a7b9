// SPDX-License-Identifier: GPL-3.0-or-later
// An unbounded plane; the half space behind it is inside.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The half space behind a plane.
struct Plane {
    Vec3 normal = Vec3(0, 1, 0);
    double distance = 0;

    static const ItemInfo vocabulary;
};

Box bounds(const Plane&);
void crossings(const Plane&, const Ray&, Crossings&);
bool inside(const Plane&, const Vec3&);
/// Finite on one side for half spaces along an axis.
Box inside_bounds(const Plane&);
/// Error that the ranges of single fields do not exclude (a normal without a direction), as a
/// sentence; empty when there is none.
std::string problem(const Plane&);

}  // namespace candelabra
