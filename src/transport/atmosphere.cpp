// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/atmosphere.h"

namespace candelabra {

Veil veil_along(const World& world, const Ray& ray, double distance,
                std::span<const PrimitiveIndex> solids, const Key& key) {
    if (!world.facts.has_air || !in_atmosphere(world, solids)) return {};
    const Veil fog = veil_of(world.sky.fogs, ray, distance, world.pattern_scene().noise_generator);
    if (world.sky.rainbows.empty()) return fog;
    return fog.before(veil_of(world.sky.rainbows, ray, distance, uniform(key, Purpose::rainbow)));
}

Veil veil_along(const World& world, const PathState& path, double distance) {
    return veil_along(world, path.ray, distance, {path.media.data(), path.media.size()}, path.key);
}

}  // namespace candelabra
