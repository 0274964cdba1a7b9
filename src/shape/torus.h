// SPDX-License-Identifier: GPL-3.0-or-later
// A torus: a tube bent to a ring around the y axis.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A ring around the y axis. A tube wider than the ring intersects itself: all of its surface is
/// hit, including the inner part.
struct Torus {
    double major = 1;
    double minor = 0.25;

    static const ItemInfo vocabulary;
};

Box bounds(const Torus&);
void crossings(const Torus&, const Ray&, Crossings&);
bool inside(const Torus&, const Vec3&);
/// See shape.h.
std::string vanishes(const Torus&);

}  // namespace candelabra
