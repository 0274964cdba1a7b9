// SPDX-License-Identifier: GPL-3.0-or-later
// White balance: the light that appears white, as with film for lamps or for daylight.
#pragma once

#include "base/rgb.h"

namespace candelabra {

/// A linear map of red, green and blue.
struct ColourMatrix {
    Vec3 red = Vec3(1, 0, 0), green = Vec3(0, 1, 0), blue = Vec3(0, 0, 1);  ///< rows

    /// Of values of any three kinds, such as XYZ.
    Vec3 operator()(const Vec3& c) const { return {dot(red, c), dot(green, c), dot(blue, c)}; }
    Rgb operator()(const Rgb& c) const { return rgb_of((*this)(vec3_of(c))); }
};

/// Returns the chromaticity x, y of a black body from 1000 to 15000 kelvins, after M. Krystek, "An
/// algorithm to calculate correlated colour temperature" (1985).
Vec2 black_body_chromaticity(double kelvins);

/// Returns a map that makes the light of a black body of this temperature white and preserves its
/// luminance, by the Bradford transform (CIE 160:2004) in sRGB primaries. 0 kelvins: the identity.
ColourMatrix white_balance(double kelvins);

}  // namespace candelabra
