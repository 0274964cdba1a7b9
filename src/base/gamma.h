// SPDX-License-Identifier: GPL-3.0-or-later
// Between linear light and colours as a scene has them, which assumed_gamma says. Used where
// pictures are read and written, and colours compared.
#pragma once

#include "base/colour.h"

#include <cmath>

namespace candelabra {

/// The gamma that stands for the curve of sRGB; others are powers.
inline constexpr double srgb_gamma = -1;

/// Of the screens that pictures are looked at on, when nothing else is known.
inline constexpr double display_gamma = 2.2;

inline double to_linear(double value, double gamma) {
    if (gamma == 1 || !(value > 0)) return value;
    return gamma < 0 ? srgb_decode(value) : std::pow(value, gamma);
}

inline double from_linear(double value, double gamma) {
    if (gamma == 1 || !(value > 0)) return value;
    return gamma < 0 ? srgb_encode(value) : std::pow(value, 1 / gamma);
}

}  // namespace candelabra
