// SPDX-License-Identifier: GPL-3.0-or-later
// Colours by value: what turns a pattern's number into a colour.
#pragma once

#include "base/colour.h"

#include <vector>

/// One entry of a colour map.
struct ColourStop {
    double value = 0;
    Colour colour;
    friend bool operator==(const ColourStop&, const ColourStop&) = default;
};

/// Stops in the order of the text. Never empty where it is looked up.
using ColourMap = std::vector<ColourStop>;

/// Linear between the stops around the value; the first stop below them, the last above. Where
/// stops share a value, the first counts at the value itself and the last just above it.
Colour look_up(const ColourMap&, double value);
