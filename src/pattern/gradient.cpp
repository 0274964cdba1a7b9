// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/gradient.h"

double evaluate(const Gradient& gradient, const Vec3& point) {
    double along = dot(point, unit(gradient.direction));
    if (along > 1) along = std::fmod(along, 1);
    // POV-Ray's ramp: a whole step of exactly 1 stays 1, and negative values are wrapped a hair
    // later.
    along = std::fmod(along, 1.00001);
    return along < 0 ? along - std::floor(along) : along;
}
