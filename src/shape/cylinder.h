// SPDX-License-Identifier: GPL-3.0-or-later
// A right circular cylinder between two points.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A cylinder with flat ends, or an open tube.
struct Cylinder {
    Vec3 base = Vec3(0);
    Vec3 cap = Vec3(0, 1, 0);
    double radius = 1;
    bool open = false;

    static const ItemInfo vocabulary;
};

Box bounds(const Cylinder&);
void crossings(const Cylinder&, const Ray&, Crossings&);
bool inside(const Cylinder&, const Vec3&);
/// Error that the ranges of single fields do not exclude (ends that coincide), as a sentence; empty
/// when there is none.
std::string problem(const Cylinder&);
/// See shape.h.
std::string vanishes(const Cylinder&);

}  // namespace candelabra
