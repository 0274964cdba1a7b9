// SPDX-License-Identifier: GPL-3.0-or-later
// An egg: two spheres on the y axis, joined by an arc.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A sphere around the origin, one around a point above it at the distance of the first one's
/// radius, and the smooth solid of revolution between them. With a top of twice the bottom's radius
/// or more, only the sphere at the top is left, as in POV-Ray.
struct Ovus {
    double bottom_radius = 1;
    double top_radius = 0.5;

    static const ItemInfo vocabulary;
};

Box bounds(const Ovus&);
void crossings(const Ovus&, const Ray&, Crossings&);
bool inside(const Ovus&, const Vec3&);

/// Why there is nothing of it; empty otherwise.
std::string vanishes(const Ovus&);

}  // namespace candelabra
