// SPDX-License-Identifier: GPL-3.0-or-later
// Light of rays that meet nothing.
#pragma once

#include "base/colour.h"

namespace candelabra {

/// A constant colour in all directions. As in POV-Ray 3.7, its appearance depends on the ray.
struct Background {
    Colour colour;

    /// Radiance in a picture without alpha: transmit dims it, filter has no effect.
    Rgb radiance() const { return colour.rgb * (1 - colour.transmit); }
    /// Radiance of camera rays in a picture with alpha, without the transparent fraction.
    Rgb covering() const { return colour.rgb * colour.opacity(); }
    /// Radiance of all other rays, such as in mirrors, in a picture with alpha.
    Rgb mirrored() const { return colour.rgb; }
};

}  // namespace candelabra
