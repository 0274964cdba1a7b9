// SPDX-License-Identifier: GPL-3.0-or-later
// Converts between linear light and a scene's colours, which assumed_gamma defines. Used where
// pictures are read and written, and colours compared.
#pragma once

#include "base/colour.h"
#include "base/elementary.h"

#include <cmath>

namespace candelabra {

/// The gamma that stands for the sRGB curve; others are powers.
inline constexpr double srgb_gamma = -1;

/// Gamma of the display on which pictures are viewed, unless known otherwise.
inline constexpr double display_gamma = 2.2;

inline double to_linear(double value, double gamma) {
    if (gamma == 1 || !(value > 0)) return value;
    return gamma < 0 ? srgb_decode(value) : math::pow(value, gamma);
}

inline double from_linear(double value, double gamma) {
    if (gamma == 1 || !(value > 0)) return value;
    return gamma < 0 ? srgb_encode(value) : math::pow(value, 1 / gamma);
}

}  // namespace candelabra
