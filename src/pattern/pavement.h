// SPDX-License-Identifier: GPL-3.0-or-later
// Pavements of the plane y = 0: each tile is several triangles, squares or hexagons with sides of
// length 1. The value falls from 1 at the borders of the tiles to 0 inside them.
#pragma once

#include "vocabulary/item_info.h"

#include <span>

namespace candelabra {

struct Pavement {
    int number_of_sides = 3;
    int number_of_tiles = 1;
    int pattern = 1;
    int exterior = 0;
    int interior = 0;
    int form = 0;

    static const ItemInfo vocabulary;
};

/// Returns the numbers of patterns with 1, 2, ... tiles; empty: no pavement has this number of
/// sides.
std::span<const int> pavement_patterns(int number_of_sides);

/// The number of sides, the number of tiles and the pattern must exist.
double evaluate(const Pavement&, const Vec3& point);

}  // namespace candelabra
