// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/quick_lights.h"

#include "world/luminaire_choices.h"

#include <utility>

namespace candelabra {

QuickLights::QuickLights(World& world) {
    replace_all(world);
    for (World& moment : world.shutter) replace_all(moment);
}

QuickLights::~QuickLights() {
    for (Replaced& each : replaced_) *each.place = std::move(each.sampler);
}

void QuickLights::replace_all(World& world) {
    replace(world.lights.sampler, LuminaireChoices(world.lights.luminaires));
    for (SourceSet& set : world.lights.source_sets)
        if (set.drawn()) replace(set.sampler, *set.choices);
}

void QuickLights::replace(BuiltLightSampler& place, const ChoosableLights& lights) {
    if (lights.size() == 0) return;
    replaced_.push_back({&place, std::exchange(place, BuiltLightBvh(lights))});
}

}  // namespace candelabra
