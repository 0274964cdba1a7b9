// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the scene language (linear red, green, blue with filter and transmit), and the sRGB
// transfer function.
#pragma once

#include "base/rgb.h"

namespace candelabra {

/// Linear values, of any sign and size, with POV-Ray's two transparencies: filter (tinted) and
/// transmit (clear).
struct Colour {
    Rgb rgb;
    double filter = 0;
    double transmit = 0;

    /// Light that passes through a surface of this colour, per channel.
    Rgb passing() const { return filter * rgb + Rgb(transmit); }
    /// Fraction of the surface that is not transparent; may be negative.
    double opacity() const { return 1 - filter - transmit; }
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// Brightness as in POV-Ray's .gray: 0.297 r + 0.589 g + 0.114 b.
inline double grey(const Rgb& c) { return c.r * 0.297 + c.g * 0.589 + c.b * 0.114; }

/// Converts one channel from linear to sRGB-encoded and back (IEC 61966-2-1). Values outside 0..1
/// follow the curves.
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace candelabra
