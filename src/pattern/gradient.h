// SPDX-License-Identifier: GPL-3.0-or-later
// A value that grows along a direction and starts again at each whole step.
#pragma once

#include "vocabulary/item_info.h"

/// Fraction of the way along the direction.
struct Gradient {
    Vec3 direction = Vec3(0, 1, 0);

    static const ItemInfo vocabulary;
};

double evaluate(const Gradient&, const Vec3& point);
