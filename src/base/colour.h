// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of the scene language (linear red, green, blue with filter and transmit), and the sRGB
// transfer function.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// Linear values, of any sign and size, with POV-Ray's two transparencies: filter (tinted) and
/// transmit (clear).
struct Colour {
    Vec3 rgb = Vec3(0);
    double filter = 0;
    double transmit = 0;

    /// Light that passes through a surface of this colour, per channel.
    Vec3 passing() const { return filter * rgb + Vec3(transmit); }
    /// Fraction of the surface that is not transparent; may be negative.
    double opacity() const { return 1 - filter - transmit; }
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// Brightness as in POV-Ray's .gray: 0.297 r + 0.589 g + 0.114 b.
inline double grey(const Vec3& c) { return dot(c, Vec3(0.297, 0.589, 0.114)); }

/// Converts one channel from linear to sRGB-encoded and back (IEC 61966-2-1). Values outside 0..1
/// follow the curves.
double srgb_encode(double linear);
double srgb_decode(double encoded);

}  // namespace candelabra
