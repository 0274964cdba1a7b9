// SPDX-License-Identifier: GPL-3.0-or-later
// A quilt with a cushion in each unit cube.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Quilted {
    static constexpr double frequency = 0;
    double control0 = 1;
    double control1 = 1;

    static const ItemInfo vocabulary;
};

double evaluate(const Quilted&, const Vec3& point);

/// Returns the offset from the centre of the point's cube, times the height of the cushion there:
/// the tilt of a normal.
Vec3 quilted_tilt(const Quilted&, const Vec3& point);

}  // namespace candelabra
