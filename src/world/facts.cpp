// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/facts.h"

#include "surface/quality.h"
#include "world/world.h"

#include <algorithm>
#include <variant>

namespace candelabra {

namespace {

void answer_about_media(const World& world, WorldFacts& facts) {
    const Sky& sky = world.sky;
    const Appearance& looks = world.appearance;
    facts.has_air = !sky.fogs.empty() || !sky.rainbows.empty() || !sky.media.empty();
    facts.has_media = looks.any_media || !sky.media.empty();
    facts.dims_between = facts.has_air || facts.has_media;
    facts.notes_solids = looks.any_transparent || looks.any_media || facts.has_air;
    facts.indexes_solids = world.stated_view.camera.parallel || !world.photon_targets.empty() ||
                           !world.lights.volumes.empty();
}

void answer_about_light(const World& world, WorldFacts& facts) {
    const Rules& rules = world.rules;
    const bool path_traced = std::holds_alternative<PathTraced>(rules.settings.integrator);
    facts.gathers_light = rules.settings.radiosity.on && rules.quality >= quality_full;
    facts.has_indirect_light = facts.gathers_light || path_traced;
    facts.keeps_energy = path_traced;
    const Sky& sky = world.sky;
    facts.has_other_sky =
        sky.light.empty() && (sky.sphere || sky.daylight || sky.background.radiance() != Rgb(0));
    facts.is_lit_by_lamps_only =
        !facts.has_other_sky && !facts.dims_between && world.photon_targets.empty();
    facts.has_other_light = world.appearance.any_other_light || !facts.is_lit_by_lamps_only;
}

void answer_about_chance(const World& world, WorldFacts& facts) {
    const Appearance& looks = world.appearance;
    facts.light_is_drawn =
        world.lights.any_glowing() ||
        std::ranges::any_of(world.lights.source_sets, [](const SourceSet& s) { return s.drawn(); });
    facts.differs_by_light = facts.light_is_drawn || !world.sky.light.empty() ||
                             looks.any_scattering || !world.shutter.empty() ||
                             facts.has_indirect_light;
    facts.left_to_chance = facts.differs_by_light || !world.photon_targets.empty() ||
                           looks.any_drawn_media ||
                           std::ranges::any_of(world.sky.media, &Media::drawn);
}

}  // namespace

WorldFacts facts_of(const World& world) {
    WorldFacts facts;
    answer_about_media(world, facts);
    answer_about_light(world, facts);
    answer_about_chance(world, facts);
    return facts;
}

}  // namespace candelabra
