// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of light by physics: of a black body, of daylight, and of one wavelength. Colours are
// linear red, green and blue of Rec. 709 with luminance 1. What lies outside of these primaries is
// cut at 0.
#pragma once

#include "base/rgb.h"

namespace candelabra {

/// Luminance of linear red, green and blue of Rec. 709, whose white is that of D65.
inline double light_luminance(const Rgb& rgb) {
    return rgb.r * 0.2126390 + rgb.g * 0.7151687 + rgb.b * 0.0721923;
}

/// Chromaticity x and y of CIE 1931.
Vec2 planck_chromaticity(double kelvin);
Vec2 daylight_chromaticity(double kelvin);
Vec2 spectral_chromaticity(double nanometres);

/// Temperatures and wavelengths for which there are colours.
inline constexpr double min_planck = 1000, max_planck = 25000;
inline constexpr double min_daylight = 4000, max_daylight = 25000;
inline constexpr double min_wavelength = 380, max_wavelength = 780;

/// Colour of a chromaticity, in linear Rec. 709 with luminance 1.
Rgb colour_of_chromaticity(const Vec2& xy);

/// Colour of a black body, by Planck's law and the observer of CIE 1931.
inline Rgb planck_colour(double kelvin) {
    return colour_of_chromaticity(planck_chromaticity(kelvin));
}
/// Colour of daylight, by the formula of CIE 15. The correlated colour temperature is that of
/// today's scale of temperatures: D65 is at 6504 K.
inline Rgb daylight_colour(double kelvin) {
    return colour_of_chromaticity(daylight_chromaticity(kelvin));
}
/// Colour of light of one wavelength.
inline Rgb spectral_colour(double nanometres) {
    return colour_of_chromaticity(spectral_chromaticity(nanometres));
}

/// Luminous efficacy of light of one wavelength, in lumens per watt.
double spectral_efficacy(double nanometres);

}  // namespace candelabra
