// SPDX-License-Identifier: GPL-3.0-or-later
// An unbounded plane with a half space behind it.
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
/// Where a half space along an axis ends.
Box inside_bounds(const Plane&);
/// What is wrong beyond the ranges of single fields (normal without a direction), as a sentence;
/// empty when nothing is.
std::string problem(const Plane&);

}  // namespace candelabra
