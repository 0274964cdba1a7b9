// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_left.h"

#include "medium/transmittance.h"

#include <algorithm>

namespace candelabra {

void add_media(const World& world, std::span<const PrimitiveIndex> solids, MediaList& list) {
    const auto hollow = [&](PrimitiveIndex solid) { return world.material(solid).hollow; };
    if (!world.appearance.any_media || !std::ranges::all_of(solids, hollow)) return;
    for (const PrimitiveIndex solid : solids)
        if (const auto& interior = world.material(solid).interior)
            for (const Media& media : interior->media) list.push_back(&media);
}

void add_atmosphere(const World& world, MediaList& list) {
    for (const Media& media : world.sky.media) list.push_back(&media);
}

Vec3 light_left(const World& world, const WayOfLight& way, const Key& key) {
    if (!world.has_media())
        return world.transmittance(way.ray, way.tolerance, way.distance, way.around, way.apart);
    const PatternScene scene = world.pattern_scene();
    Vec3 left(1);
    std::uint32_t number = 0;
    MediaList media;
    const auto pass = [&](const Interval& stretch) {
        if (media.empty() || !(stretch.max > stretch.min)) return;
        left *= transmittance(view_of(media), way.ray, stretch, scene,
                              key.branched(Branch::medium, number++));
    };
    const auto in_solids = [&](const Interval& stretch, std::span<const PrimitiveIndex> solids) {
        media.clear();
        add_media(world, solids, media);
        pass({stretch.min, std::min(stretch.max, end_of_air)});
    };
    const World::UseStretch use(in_solids);
    const bool asks = world.appearance.any_media;
    const Vec3 passed = world.transmittance(way.ray, way.tolerance, way.distance,
                                            {way.around, way.apart, asks ? &use : nullptr});
    if (passed == Vec3(0)) return passed;
    left *= passed;
    if (!way.in_atmosphere) return left;
    media.clear();
    add_atmosphere(world, media);
    pass({0, std::min(way.distance, end_of_air)});
    return left;
}

}  // namespace candelabra
