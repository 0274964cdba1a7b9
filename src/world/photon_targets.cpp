// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/photon_targets.h"

#include "surface/quality.h"
#include "text/diagnostic.h"
#include "text/message.h"
#include "world/world.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

constexpr PhotonWays without_photons = {PhotonWay::off, PhotonWay::off};

Box bounds_of(const Geometry& geometry, PrimitiveIndex primitive) {
    const PlacedComposite* placed = geometry.composite(geometry.item_of(primitive));
    return placed ? placed->composite->leaf_bounds(primitive - placed->first_leaf)
                  : geometry.bounds(primitive);
}

/// Calls use(target, primitive) for the surfaces of all targets.
template <class Use>
void for_surfaces(World& world, const Use& use) {
    for (PrimitiveIndex i = 0; i < world.appearance.material_of.size(); ++i) {
        const Material& material = world.material(i);
        if (material.photons.target != 0 && !material.no_shadow)
            use(world.photon_targets[material.photons.target - 1], i);
    }
}

/// Finds balls around the targets. The radius is 0 for targets without surfaces, and infinite for
/// unbounded ones.
void bound(World& world) {
    std::vector<Box> boxes(world.photon_targets.size());
    std::vector<PrimitiveIndex> only(boxes.size(), no_primitive);
    std::vector<int> count(boxes.size());
    for_surfaces(world, [&](PhotonTarget& target, PrimitiveIndex primitive) {
        const auto number = static_cast<std::size_t>(&target - world.photon_targets.data());
        boxes[number] = join(boxes[number], bounds_of(world.geometry, primitive));
        only[number] = primitive;
        ++count[number];
        target.shot_at |= !world.material(primitive).no_image;
    });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        PhotonTarget& target = world.photon_targets[i];
        if (boxes[i].empty()) continue;
        if (!finite(boxes[i])) {
            target.radius = std::numeric_limits<double>::infinity();
            continue;
        }
        target.centre = boxes[i].centre();
        const bool ball = count[i] == 1 && only[i] < world.geometry.triangles_begin();
        target.radius = ball ? world.geometry.spheres[only[i]].radius : 0;
    }
    for_surfaces(world, [&](PhotonTarget& target, PrimitiveIndex primitive) {
        const auto number = static_cast<std::size_t>(&target - world.photon_targets.data());
        if (!std::isfinite(target.radius) || (count[number] == 1 && target.radius > 0)) return;
        const Box box = bounds_of(world.geometry, primitive);
        if (!box.empty())
            target.radius =
                std::fmax(target.radius, std::sqrt(farthest_distance2(box, target.centre)));
    });
}

/// Number of light sources for each combination of photon settings; there are few combinations.
using SourcesOfWays = std::vector<std::pair<PhotonWays, std::uint64_t>>;

SourcesOfWays sources_of_ways(const World& world) {
    SourcesOfWays made;
    for (std::uint32_t light = 0; light < world.lights.sources.size(); ++light) {
        const PhotonWays ways = ways_of_source(world, light);
        const auto known = std::ranges::find(made, ways, &SourcesOfWays::value_type::first);
        if (known == made.end())
            made.emplace_back(ways, 1);
        else
            ++known->second;
    }
    return made;
}

/// Number of pairs of a lamp and a target that it shoots at.
struct PhotonPairs {
    std::uint64_t of_sources = 0, of_luminaires = 0;
};

PhotonPairs photon_pairs(const World& world) {
    PhotonPairs pairs;
    const SourcesOfWays sources = sources_of_ways(world);
    for (const PhotonTarget& target : world.photon_targets) {
        if (!target.shot_at) continue;
        for (const auto& [ways, count] : sources)
            if (any_open(ways, target.ways)) pairs.of_sources += count;
        if (any_open(ways_of_luminaires, target.ways))
            pairs.of_luminaires += world.lights.glowing();
    }
    return pairs;
}

/// A pair with a source takes 40 bytes, and one with a luminaire about 20 nanoseconds.
constexpr std::uint64_t max_of_sources = 8'000'000, max_of_luminaires = 60'000'000;

void refuse_many(const World& world, const PhotonPairs& pairs, Diagnostics& diagnostics) {
    const bool sources = pairs.of_sources > max_of_sources;
    if (!sources && pairs.of_luminaires <= max_of_luminaires) return;
    const auto target = std::ranges::find(world.photon_targets, true, &PhotonTarget::shot_at);
    diagnostics.add(
        error(Fault::out_of_range, target->span,
              message("photons of ", sources ? "light sources" : "things that glow",
                      " are shot at targets in more pairs than the limit of ",
                      sources ? max_of_sources : max_of_luminaires, ": there are ",
                      sources ? pairs.of_sources : pairs.of_luminaires))
            .with_help("a `union` with `photons { target }` is one target, and lights with "
                       "`photons { refraction off reflection off }` shoot at none"));
}

}  // namespace

PhotonSurface photon_surface(World& world, const ObjectPhotons& said, Span span) {
    PhotonSurface surface{0, said.ways(), said.collect, said.pass_through};
    if (said.target.value_or(0) == 0) return surface;
    world.photon_targets.push_back({span, *said.target > 0 ? *said.target : 1, surface.ways});
    surface.target = static_cast<std::uint32_t>(world.photon_targets.size());
    return surface;
}

PhotonWays ways_of_source(const World& world, std::uint32_t light) {
    const LightReach& reach = world.lights.reach[light];
    return world.lights.sources[light].shadowless || reach.window ? without_photons : reach.photons;
}

void place_photon_targets(World& world, Diagnostics& diagnostics) {
    std::vector<PhotonTarget>& targets = world.photon_targets;
    if (targets.empty()) return;
    const bool wanted =
        world.rules.settings.photons.shoots() && world.rules.quality >= quality_full;
    if (wanted) bound(world);
    std::vector<bool> counts;
    for (PhotonTarget& target : targets) {
        if (!std::isfinite(target.radius))
            diagnostics.add(
                warning(Fault::no_effect, target.span,
                        "this object has no end, so that no photons can be shot at it")
                    .with_help("a large `box` or `disc` can be a `target` in its place"));
        counts.push_back(target.radius > 0 && std::isfinite(target.radius));
        target.shot_at = target.shot_at && counts.back();
    }
    const PhotonPairs pairs = photon_pairs(world);
    refuse_many(world, pairs, diagnostics);
    const bool any = pairs.of_sources + pairs.of_luminaires > 0;
    for (Material& material : world.appearance.materials) {
        std::uint32_t& target = material.photons.target;
        if (target != 0 && (!any || material.no_shadow || !counts[target - 1])) target = 0;
    }
    if (!any) targets.clear();
}

bool target_between(const World& world, const PhotonWays& lamp, const Ray& ray, double from,
                    double to) {
    // The light itself may lie on a surface.
    const double end = to * (1 - 1e-7) - from;
    bool met = false;
    world.along(ray, from, RayKind::light, [&](const Hit& hit, double distance) {
        if (distance >= end) return false;
        const PhotonSurface& surface = world.material(hit.primitive).photons;
        met = surface.target != 0 && is_open(lamp.refraction, surface.ways.refraction);
        return !met;
    });
    return met;
}

}  // namespace candelabra
