// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative rounding to single precision. Used where boxes and packs of leaves are made for
// rays.
#pragma once

#include <cmath>
#include <limits>

namespace candelabra {

inline float rounded_up(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest < x ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}
inline float rounded_down(double x) { return -rounded_up(-x); }

}  // namespace candelabra
