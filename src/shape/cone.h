// SPDX-License-Identifier: GPL-3.0-or-later
// A right circular cone or frustum between two points.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A cone whose radius varies linearly from one end to the other.
struct Cone {
    Vec3 base = Vec3(0);
    double base_radius = 1;
    Vec3 cap = Vec3(0, 1, 0);
    double cap_radius = 0;
    bool open = false;

    static const ItemInfo vocabulary;
};

Box bounds(const Cone&);
void crossings(const Cone&, const Ray&, Crossings&);
bool inside(const Cone&, const Vec3&);
/// Error that the ranges of single fields do not exclude (ends that coincide), as a sentence; empty
/// when there is none.
std::string problem(const Cone&);
/// See shape.h.
std::string vanishes(const Cone&);

}  // namespace candelabra
