// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray sees that meets nothing.
#pragma once

#include "base/colour.h"

/// One colour in all directions. Its transmit dims it; its filter has no effect, as in POV-Ray 3.7.
struct Background {
    Colour colour;

    Vec3 radiance() const { return colour.rgb * (1 - colour.transmit); }
};
