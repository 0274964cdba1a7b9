// SPDX-License-Identifier: GPL-3.0-or-later
// A torus: a tube bent to a ring around the y axis.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// A ring around the y axis. A tube wider than the ring intersects itself: all of its surface is
/// hit, including the inner part. The words of POV-Ray 3.8 say what becomes of its spindle, which
/// the tube covers twice; of several words the last in this order counts.
struct Torus {
    double major = 1;
    double minor = 0.25;
    bool whole = false;    ///< as without a word: `union`
    bool merged = false;   ///< the spindle's surface is not there: `merge`
    bool hollow = false;   ///< the spindle is outside: `difference`
    bool spindle = false;  ///< the spindle is all: `intersection`

    static const ItemInfo vocabulary;
};

Box bounds(const Torus&);
void crossings(const Torus&, const Ray&, Crossings&);
bool inside(const Torus&, const Vec3&);
/// See shape.h.
std::string vanishes(const Torus&);

}  // namespace candelabra
