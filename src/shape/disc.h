// SPDX-License-Identifier: GPL-3.0-or-later
// A flat disc, with or without a hole.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A full disc or a flat ring. Its inside is the half space behind it, as in POV-Ray 3.7.
struct Disc {
    Vec3 centre = Vec3(0);
    Vec3 normal = Vec3(0, 1, 0);
    double radius = 1;
    double hole = 0;

    static const ItemInfo vocabulary;
};

Box bounds(const Disc&);
void crossings(const Disc&, const Ray&, Crossings&);
bool inside(const Disc&, const Vec3&);
/// Infinite, as is the half space behind the disc.
Box inside_bounds(const Disc&);
/// Error that the ranges of single fields do not exclude (a normal without a direction), as a
/// sentence; empty when there is none.
std::string problem(const Disc&);
/// See shape.h.
std::string vanishes(const Disc&);

}  // namespace candelabra
