// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/default_maps.h"

namespace candelabra {

namespace {

Colour rgb(double red, double green, double blue) { return {Rgb(red, green, blue)}; }

/// Blue, green, red for two and three entries; starts with red for more.
ColourMap list_of(int length) {
    const Colour red = rgb(1, 0, 0), green = rgb(0, 1, 0), blue = rgb(0, 0, 1);
    const std::vector<Colour> few = {blue, green, red};
    const std::vector<Colour> many = {red, green, blue, rgb(1, 1, 0), rgb(0, 1, 1), rgb(1, 0, 1)};
    ColourMap map;
    for (int i = 0; i < length; ++i)
        map.push_back(
            {static_cast<double>(i), (length <= 3 ? few : many)[static_cast<std::size_t>(i)]});
    return map;
}

ColourMap map_of(const Agate&) {
    return {{0, rgb(1, 1, 1)},         {0.5, rgb(0.95, 0.75, 0.5)}, {0.5, rgb(0.9, 0.7, 0.5)},
            {0.6, rgb(0.9, 0.7, 0.4)}, {0.6, rgb(1, 0.7, 0.4)},     {1, rgb(0.6, 0.3, 0)}};
}

ColourMap map_of(const Bozo&) {
    return {{0.4, rgb(1, 1, 1)}, {0.4, rgb(0, 1, 0)}, {0.6, rgb(0, 1, 0)},
            {0.6, rgb(0, 0, 1)}, {0.8, rgb(0, 0, 1)}, {0.8, rgb(1, 0, 0)}};
}

ColourMap map_of(const Brick&) { return {{0, rgb(0.5, 0.5, 0.5)}, {1, rgb(0.6, 0.15, 0.15)}}; }

ColourMap map_of(const Mandel& mandel) {
    if (mandel.exponent != 2) return {{0, rgb(0, 0, 0)}, {1, rgb(1, 1, 1)}};
    return {{0.001, rgb(0, 0, 0)},
            {0.001, rgb(0, 1, 1)},
            {0.012, rgb(1, 1, 0)},
            {0.015, rgb(1, 0, 1)},
            {0.1, rgb(0, 1, 1)}};
}

ColourMap map_of(const Marble&) {
    return {{0, rgb(0.9, 0.8, 0.8)}, {0.9, rgb(0.9, 0.08, 0.08)}, {0.9, rgb(0, 0, 0)}};
}

ColourMap map_of(const Radial&) {
    return {{0, rgb(0, 1, 1)}, {0.333, rgb(1, 1, 0)}, {0.666, rgb(1, 0, 1)}, {1, rgb(0, 1, 1)}};
}

ColourMap map_of(const Wood&) {
    return {{0.6, rgb(0.666, 0.312, 0.2)}, {0.6, rgb(0.4, 0.1333, 0.066)}};
}

}  // namespace

ColourMap default_map(const Pattern& pattern) {
    ColourMap map = std::visit(
        []<class T>(const T& kind) -> ColourMap {
            if constexpr (requires { map_of(kind); })
                return map_of(kind);
            else if constexpr (requires { T::choices; })
                return list_of(T::choices);
            else
                return {{0, rgb(0, 0, 0)}, {1, rgb(1, 1, 1)}};
        },
        pattern);
    for (ColourStop& stop : map) stop.value = single_precision(stop.value);
    return map;
}

}  // namespace candelabra
