// SPDX-License-Identifier: GPL-3.0-or-later
// An axis-aligned box. (The class is Cuboid because base/box.h has Box for bounds.)
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The axis-aligned solid between two opposite corners.
struct Cuboid {
    Vec3 corner1 = Vec3(0);
    Vec3 corner2 = Vec3(1);

    static const ItemInfo vocabulary;
};

Box bounds(const Cuboid&);
void crossings(const Cuboid&, const Ray&, Crossings&);
bool inside(const Cuboid&, const Vec3&);

}  // namespace candelabra
