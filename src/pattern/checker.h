// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cubes of two colours in turn.
#pragma once

#include "vocabulary/schema.h"

/// 0 or 1 by the parity of the unit cube that a point lies in.
struct Checker {
    static consteval auto vocabulary();
};

consteval auto Checker::vocabulary() {
    return schema<Checker>("checker", "Unit cubes of two colours in turn.");
}

/// Points within 1e-10 below a cube's face count as on it, so that a floor at a whole height does
/// not flicker.
double evaluate(const Checker&, const Vec3& point);
