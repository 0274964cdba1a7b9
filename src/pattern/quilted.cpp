// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/quilted.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Quilted::vocabulary = described<Quilted>([] {
    using F = Field<Quilted>;
    return schema<Quilted>("quilted",
                           {"A cushion in each unit cube.", "pigment { quilted scale 0.4 }",
                            "pigment { quilted control0 0.2 control1 0.8 scale 0.4 }"},
                           F{"control0", &Quilted::control0, item, "steepness of the seams"},
                           F{"control1", &Quilted::control1, item, "steepness of the middle"});
});

namespace {

/// Returns the offset from the centre of the cube; negative integers belong to the cube below.
double from_middle(double t) {
    const double cube = t >= 0 ? std::floor(t) : -std::floor(-t) - 1;
    return t - cube - 0.5;
}

/// A cubic curve from 0 at the centre to 1 at the corner, scaled for continuity at the centre of a
/// face.
double height(const Quilted& quilted, double distance) {
    const double rest = 1 - distance;
    return 1.154700538 * (distance * distance * distance +
                          3 * distance * rest * rest * single_precision(quilted.control0) +
                          3 * distance * distance * rest * single_precision(quilted.control1));
}

}  // namespace

Vec3 quilted_tilt(const Quilted& quilted, const Vec3& point) {
    const Vec3 offset(from_middle(point.x), from_middle(point.y), from_middle(point.z));
    return height(quilted, length(offset)) * offset;
}

double evaluate(const Quilted& quilted, const Vec3& point) {
    const Vec3 offset(from_middle(point.x), from_middle(point.y), from_middle(point.z));
    return std::abs(height(quilted, length(offset))) *
           (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z)) / 3;
}

}  // namespace candelabra
