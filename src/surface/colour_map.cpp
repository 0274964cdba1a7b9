// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/colour_map.h"

Colour look_up(const ColourMap& map, double value) {
    if (value >= map.back().value) return map.back().colour;
    std::size_t next = 0;
    while (next + 1 < map.size() && value > map[next].value) ++next;
    const ColourStop& above = map[next];
    if (next == 0 || value == above.value) return above.colour;
    const ColourStop& below = map[next - 1];
    const double share = (value - below.value) / (above.value - below.value);
    const auto between = [share](const auto& a, const auto& b) { return a + share * (b - a); };
    return {between(below.colour.rgb, above.colour.rgb),
            between(below.colour.filter, above.colour.filter),
            between(below.colour.transmit, above.colour.transmit)};
}
