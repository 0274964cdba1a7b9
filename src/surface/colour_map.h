// SPDX-License-Identifier: GPL-3.0-or-later
// Maps from the value of a pattern to a colour.
#pragma once

#include "base/colour.h"

#include <vector>

namespace candelabra {

/// One entry of a colour map.
struct ColourStop {
    double value = 0;
    Colour colour;
    friend bool operator==(const ColourStop&, const ColourStop&) = default;
};

/// Stops in textual order. Never empty when looked up.
using ColourMap = std::vector<ColourStop>;

/// The colour at a value, according to map_place.h.
Colour look_up(const ColourMap&, double value);

/// Interpolates all components linearly.
Colour mixed(const Colour& from, const Colour& to, double share);

}  // namespace candelabra
