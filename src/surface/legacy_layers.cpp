// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/legacy_layers.h"

#include "surface/pigment_map.h"

namespace candelabra {

namespace {

Colour converted(Colour colour) {
    colour.transmit += colour.filter;
    colour.filter = 0;
    return colour;
}

Pigment converted(Pigment pigment) {
    pigment.colour = converted(pigment.colour);
    if (!pigment.pattern) return pigment;
    PatternedPigment::Map map = pigment.pattern->map;
    if (auto* colours = std::get_if<ColourMap>(&map))
        for (ColourStop& stop : *colours) stop.colour = converted(stop.colour);
    else
        for (PigmentStop& stop : std::get<PigmentMap>(map)) stop.pigment = converted(stop.pigment);
    pigment.pattern = make_handle<PatternedPigment>(pigment.pattern->use, std::move(map));
    return pigment;
}

}  // namespace

Texture with_filter_as_transmit(Texture texture) {
    texture.pigment = converted(std::move(texture.pigment));
    if (texture.below)
        texture.below = make_handle<Texture>(with_filter_as_transmit(*texture.below));
    return texture;
}

}  // namespace candelabra
