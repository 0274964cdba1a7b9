// SPDX-License-Identifier: GPL-3.0-or-later
// Colours by value: what turns a pattern's number into a colour.
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

/// Stops in the order of the text. Never empty where it is looked up.
using ColourMap = std::vector<ColourStop>;

/// The colour at a value, by the rules of map_place.h.
Colour look_up(const ColourMap&, double value);

/// From one colour to another, all components linearly.
Colour mixed(const Colour& from, const Colour& to, double share);

}  // namespace candelabra
