// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of the second degree: ellipsoids, paraboloids, hyperboloids, cones, cylinders, pairs of
// planes.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The points with A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J <= 0, where
/// squares = <A, B, C>, products = <D, E, F>, linear = <G, H, I>.
struct Quadric {
    Vec3 squares = Vec3(1);
    Vec3 products = Vec3(0);
    Vec3 linear = Vec3(0);
    double constant = -1;

    static const ItemInfo vocabulary;
};

/// Infinite along axes on which the solid is unbounded or has no known bound.
Box bounds(const Quadric&);
void crossings(const Quadric&, const Ray&, Crossings&);
void crossings_between(const Quadric&, const Ray&, const Interval& range, Crossings&);
bool inside(const Quadric&, const Vec3&);
/// Bounds of the part of the solid in a box, as far as known. The box may be infinite.
Box bounds_within(const Quadric&, const Box&);
std::string vanishes(const Quadric&);

}  // namespace candelabra
