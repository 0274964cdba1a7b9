// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that fall from 1 at a point, a line or a plane to 0 at distance 1 and beyond.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

struct Boxed {
    static const ItemInfo vocabulary;
};

struct PlanarPattern {
    static const ItemInfo vocabulary;
};

struct CylindricalPattern {
    static const ItemInfo vocabulary;
};

struct SphericalPattern {
    static const ItemInfo vocabulary;
};

double evaluate(const Boxed&, const Vec3& point);
double evaluate(const PlanarPattern&, const Vec3& point);
double evaluate(const CylindricalPattern&, const Vec3& point);
double evaluate(const SphericalPattern&, const Vec3& point);

}  // namespace candelabra
