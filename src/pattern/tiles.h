// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that choose from a list: checker, brick, hexagon, square, triangular, cubic. Their value
// is the index in the list, from 0 on. `choices` is the length of the list. They do not repeat, so
// their frequency is 0.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

struct Checker {
    static constexpr int choices = 2;

    static const ItemInfo vocabulary;
};

struct Brick {
    static constexpr int choices = 2;
    Vec3 brick_size = Vec3(8, 3, 4.5);
    double mortar = 0.5;

    static const ItemInfo vocabulary;
};

struct Hexagon {
    static constexpr int choices = 3;

    static const ItemInfo vocabulary;
};

struct Square {
    static constexpr int choices = 4;

    static const ItemInfo vocabulary;
};

struct Triangular {
    static constexpr int choices = 6;

    static const ItemInfo vocabulary;
};

struct CubicPattern {
    static constexpr int choices = 6;

    static const ItemInfo vocabulary;
};

/// Points within 1e-10 below a cube's face count as on it, so that a floor at an integer height
/// does not flicker.
double evaluate(const Checker&, const Vec3& point);
double evaluate(const Brick&, const Vec3& point);
double evaluate(const Hexagon&, const Vec3& point);
double evaluate(const Square&, const Vec3& point);
double evaluate(const Triangular&, const Vec3& point);
double evaluate(const CubicPattern&, const Vec3& point);

}  // namespace candelabra
