// SPDX-License-Identifier: GPL-3.0-or-later
// A value that grows along a direction and starts again at each whole step.
#pragma once

#include "vocabulary/schema.h"

/// Fraction of the way along the direction.
struct Gradient {
    Vec3 direction = Vec3(0, 1, 0);

    static consteval auto vocabulary();
};

consteval auto Gradient::vocabulary() {
    using F = Field<Gradient>;
    return schema<Gradient>(
        "gradient", "A value that grows along a direction and starts again at each whole step.",
        F{"direction", &Gradient::direction, positional,
          "direction of growth; only its direction counts"});
}

double evaluate(const Gradient&, const Vec3& point);
