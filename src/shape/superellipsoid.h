// SPDX-License-Identifier: GPL-3.0-or-later
// A superellipsoid: between box, cylinder, sphere and octahedron, within the cube from -1 to 1.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// The points with ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2) <= 1 for exponents <e, n>.
struct Superellipsoid {
    Vec2 exponents = Vec2(0.5, 0.5);

    static const ItemInfo vocabulary;
};

Box bounds(const Superellipsoid&);
void crossings(const Superellipsoid&, const Ray&, Crossings&);
void nearest_crossings(const Superellipsoid&, const Ray&, const Interval& range, Crossings&);
bool inside(const Superellipsoid&, const Vec3&);

}  // namespace candelabra
