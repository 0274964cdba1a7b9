// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/checker.h"

#include "vocabulary/schema.h"

const ItemInfo Checker::vocabulary = described<Checker>(
    [] { return schema<Checker>("checker", "Unit cubes of two colours in turn."); });

double evaluate(const Checker&, const Vec3& point) {
    constexpr double tolerance = 1e-10;
    const double sum = std::floor(point.x + tolerance) + std::floor(point.y + tolerance) +
                       std::floor(point.z + tolerance);
    return std::fmod(std::abs(sum), 2);
}
