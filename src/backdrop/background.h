// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray sees that meets nothing.
#pragma once

#include "base/colour.h"

namespace candelabra {

/// One colour in all directions. How it is seen depends on the ray, as in POV-Ray 3.7.
struct Background {
    Colour colour;

    /// Its transmit dims it, and its filter has no effect.
    Vec3 radiance() const { return colour.rgb * (1 - colour.transmit); }
    /// In a picture with alpha, straight on: what is clear is not seen.
    Vec3 covering() const { return colour.rgb * colour.opacity(); }
    /// In a picture with alpha, in mirrors.
    Vec3 mirrored() const { return colour.rgb; }
};

}  // namespace candelabra
