// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cubes of two colours in turn.
#pragma once

#include "vocabulary/item_info.h"

/// 0 or 1 by the parity of the unit cube that a point lies in.
struct Checker {
    static const ItemInfo vocabulary;
};

/// Points within 1e-10 below a cube's face count as on it, so that a floor at a whole height does
/// not flicker.
double evaluate(const Checker&, const Vec3& point);
