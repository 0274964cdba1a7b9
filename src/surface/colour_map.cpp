// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/colour_map.h"

#include "surface/map_place.h"

namespace candelabra {

Colour look_up(const ColourMap& map, double value) {
    const MapPlace at = place_in(map, value);
    if (at.share == 0) return map[at.below].colour;
    return mixed(map[at.below].colour, map[at.above].colour, at.share);
}

Colour mixed(const Colour& from, const Colour& to, double share) {
    const auto between = [share](const auto& a, const auto& b) { return a + share * (b - a); };
    return {between(from.rgb, to.rgb), between(from.filter, to.filter),
            between(from.transmit, to.transmit)};
}

}  // namespace candelabra
