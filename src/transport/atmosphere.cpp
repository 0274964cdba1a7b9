// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/atmosphere.h"

namespace candelabra {

Veil veil_along(const World& world, const PathState& path, double distance) {
    if (!world.has_air() || !in_atmosphere(world, path.media)) return {};
    const Veil fog =
        veil_of(world.sky.fogs, path.ray, distance, world.pattern_scene().noise_generator);
    if (world.sky.rainbows.empty()) return fog;
    return fog.before(
        veil_of(world.sky.rainbows, path.ray, distance, uniform(path.key, Purpose::rainbow)));
}

}  // namespace candelabra
