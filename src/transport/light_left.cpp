// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_left.h"

#include "medium/transmittance.h"
#include "transport/atmosphere.h"
#include "transport/layer_stack.h"
#include "transport/media_stack.h"
#include "world/volumes.h"

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

void add_followed(const World& world, std::span<const PrimitiveIndex> solids, bool ends,
                  MediaList& list) {
    if (ends) add_media(world, solids, list);
    if (in_atmosphere(world, solids)) add_atmosphere(world, list);
}

namespace {

Rgb left_by_media(const World& world, const MediaList& media, const AirStretch& stretch,
                  const Key& key) {
    const Interval part{stretch.part.min, std::min(stretch.part.max, end_of_air)};
    if (media.empty() || !(part.max > part.min)) return Rgb(1);
    return transmittance(view_of(media), stretch.ray, part, world.pattern_scene(), key);
}

/// Whether anything but surfaces dims light.
bool dims(const World& world, AirOnWay air) {
    switch (air) {
        case AirOnWay::none:
            return false;
        case AirOnWay::in_solids:
            return world.appearance.any_media;
        case AirOnWay::followed:
        case AirOnWay::throughout:
            break;
    }
    return world.facts.dims_between;
}

/// Transmittance of media and fog outside of solids on the whole way.
Rgb left_throughout(const World& world, const WayOfLight& way, const Key& key) {
    MediaList media;
    add_atmosphere(world, media);
    const Rgb left =
        left_by_media(world, media, {way.ray, {0, way.distance}, {}}, key.branched(Branch::medium));
    if (left == Rgb(0)) return left;
    return left *
           left_by(world.sky.fogs, way.ray, way.distance, world.pattern_scene().noise_generator);
}

/// Transmittance of the air on the part of a way with that number, between two surfaces.
Rgb left_on_part(const World& world, const WayOfLight& way, const Interval& part,
                 std::span<const PrimitiveIndex> solids, const Key& key, std::uint32_t number) {
    const Key own = key.branched(Branch::medium, number);
    const AirStretch stretch{way.ray, part, solids, way.ends || part.max < way.distance};
    if (way.air == AirOnWay::followed) return left_in_air(world, stretch, own);
    MediaList media;
    add_media(world, solids, media);
    return left_by_media(world, media, stretch, own);
}

/// The number of the first part of a way: before it, air that is the same throughout has a number.
std::uint32_t first_part(AirOnWay air) { return air == AirOnWay::throughout ? 1 : 0; }

}  // namespace

Rgb left_in_air(const World& world, const AirStretch& stretch, const Key& key) {
    MediaList media;
    add_followed(world, stretch.solids, stretch.ends, media);
    const Rgb left = left_by_media(world, media, stretch, key);
    if (world.sky.fogs.empty() && world.sky.rainbows.empty()) return left;
    const Ray from{stretch.ray.at(stretch.part.min), stretch.ray.direction};
    const double distance = stretch.part.max - stretch.part.min;
    return left * veil_along(world, from, distance, stretch.solids, key).transmittance;
}

Rgb light_left(const World& world, const WayOfLight& way, const Key& key) {
    StraightWay straight(world, way.ray);
    const auto at_surface = [&](const Hit& hit, std::span<const PrimitiveIndex> solids) {
        return straight.passed(hit, solids);
    };
    const World::UseSurface surfaces(at_surface);
    const bool reflect = world.appearance.any_keeps_energy && world.facts.keeps_energy;
    World::Shade shade{way.around, way.apart, nullptr, reflect ? &surfaces : nullptr};
    if (!dims(world, way.air))
        return world.transmittance(way.ray, way.tolerance, way.distance, shade);
    Rgb left(1);
    std::uint32_t number = first_part(way.air);
    const auto between = [&](const Interval& part, std::span<const PrimitiveIndex> solids) {
        if (part.max > part.min) left *= left_on_part(world, way, part, solids, key, number++);
    };
    const World::UseStretch stretches(between);
    shade.stretches = &stretches;
    const Rgb passed = world.transmittance(way.ray, way.tolerance, way.distance, shade);
    if (passed == Rgb(0)) return passed;
    left *= passed;
    return way.air == AirOnWay::throughout ? left * left_throughout(world, way, key) : left;
}

Rgb left_on_free_way(const World& world, const WayOfLight& way, const Key& key) {
    if (!dims(world, way.air)) return Rgb(1);
    EnteredSolids inside;
    for (const PrimitiveIndex each : way.around)
        if (!world.material(each).no_shadow) inside.push_back(each);
    const Rgb left = left_on_part(world, way, {0, way.distance}, {inside.data(), inside.size()},
                                  key, first_part(way.air));
    return way.air == AirOnWay::throughout ? left * left_throughout(world, way, key) : left;
}

namespace {

/// Fraction of the light that a lamp's solid lets through up to a distance, where the light starts.
Rgb left_by_own_solid(const World& world, PrimitiveIndex lamp, double end, const WayOfLight& way,
                      const Key& key) {
    if (!world.material(lamp).no_shadow) return Rgb(1);
    EnteredSolids inside;
    for (const PrimitiveIndex each : way.around) inside.push_back(each);
    StraightWay straight(world, way.ray);
    Rgb left(1);
    double before = 0;
    std::uint32_t number = 0;
    const auto pass = [&](double until) {
        const Key own = key.branched(Branch::medium, number++);
        const auto solid = std::ranges::find_if(
            inside, [&](PrimitiveIndex each) { return is_same_solid(world, each, lamp); });
        if (solid == inside.end() || way.air == AirOnWay::none) return;
        MediaList media, others;
        add_media(world, {&*solid, 1}, media);
        add_media(world, {inside.data(), inside.size()}, others);
        if (!others.empty())
            left *= left_by_media(world, media, {way.ray, {before, until}, {}}, own);
    };
    world.along(way.ray, way.tolerance, RayKind::light, [&](const Hit& hit, double t) {
        pass(std::min(t, end));
        if (t >= end) return false;
        const std::span<const PrimitiveIndex> around(inside.data(), inside.size());
        if (is_same_solid(world, hit.primitive, lamp)) {
            const auto& interior = world.material(hit.primitive).interior;
            left *= straight.seen(hit, around);
            if (interior && interior->fade_distance != 0 && is_in(world, inside, hit.primitive))
                left *= attenuation(*interior, t - before);
        }
        world.pass(hit.primitive, inside);
        before = t;
        return left != Rgb(0);
    });
    return left;
}

}  // namespace

Rgb left_by_lamp(const World& world, const Luminaire& luminaire, const WayOfLight& way,
                 const Key& key) {
    return left_by_own_solid(world, luminaire.primitive,
                             World::end_of_way(way.tolerance, way.distance).min, way, key);
}

Rgb left_by_lamp(const World& world, const MediaBox& box, const WayOfLight& way, const Key& key) {
    const Rgb left = left_by_own_solid(world, box.primitive, way.distance, way, key);
    return way.air == AirOnWay::none ? left
                                     : left * left_by_fog_behind(world, way.ray, way.distance, key);
}

Rgb left_by_fog_behind(const World& world, const Ray& ray, double distance, const Key& key) {
    if (world.sky.fogs.empty() && world.sky.rainbows.empty()) return Rgb(1);
    Hit hit;
    const bool ends = world.first_hit(ray, distance, RayKind::gathering, hit);
    const Ray behind{ray.at(distance), ray.direction};
    return veil_along(world, behind, ends ? length(hit.position - behind.origin) : far_away, {},
                      key)
        .transmittance;
}

}  // namespace candelabra
