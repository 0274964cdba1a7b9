// SPDX-License-Identifier: GPL-3.0-or-later
// Tilings of the plane y = 0 by polygons: the value distinguishes kinds of tiles and falls towards
// their borders.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

struct Tiling {
    int type = 1;

    static const ItemInfo vocabulary;
};

double evaluate(const Tiling&, const Vec3& point);

}  // namespace candelabra
