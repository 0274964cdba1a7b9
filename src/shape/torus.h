// SPDX-License-Identifier: GPL-3.0-or-later
// A torus: the surface of a tube that is bent to a ring around the y axis.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A ring around the y axis. A tube wider than the ring passes through itself: all of its surface
/// is met, also the part within.
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
