// SPDX-License-Identifier: GPL-3.0-or-later
// An egg: two spheres on the y axis, joined by an arc.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A sphere around the origin, one around a point above it at the distance of the first one's
/// radius, and the smooth solid of revolution between them. If the top radius is at least twice the
/// bottom radius, only the top sphere is left, as in POV-Ray.
struct Ovus {
    double bottom_radius = 1;
    double top_radius = 0.5;

    static const ItemInfo vocabulary;
};

Box bounds(const Ovus&);
void crossings(const Ovus&, const Ray&, Crossings&);
bool inside(const Ovus&, const Vec3&);

/// See shape.h.
std::string vanishes(const Ovus&);

}  // namespace candelabra
