// SPDX-License-Identifier: GPL-3.0-or-later
// What gives light in a world, except for its sky. Filled by flatten() and compile().
#pragma once

#include "method/photons.h"
#include "world/sources.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Objects that are lit by the same lights.
struct LightGroup {
    std::uint32_t outer = 0;    ///< another group whose lights light it as well; 0: none
    bool global_lights = true;  ///< lights of no group light its objects
};

/// What restricts a light.
struct LightReach {
    std::uint32_t group = 0;             ///< it lights the objects of this group only; 0: all
    Handle<Composite> window = nullptr;  ///< it lights what is seen through this; null: all
    PhotonWays photons = {};             ///< what it says of them
    bool photons_of_grid = false;        ///< they start from all of its grid
};

/// A solid whose media light the scene.
struct GlowingVolume {
    PrimitiveIndex primitive = no_primitive;  ///< one of it
    std::uint32_t statement = 0;              ///< of Provenance::light_statements
};

/// What gives light, except for the sky.
struct WorldLights {
    std::vector<Luminaire> luminaires;
    /// Per primitive: index in luminaires, or no_primitive; empty if there are none. What fills the
    /// inside of a primitive is none of its own.
    std::vector<std::uint32_t> luminaire_of;
    std::vector<GlowingVolume> volumes;
    BuiltLightSampler sampler;  ///< among the luminaires
    std::vector<Light> sources;
    std::vector<LightReach> reach;       ///< of each source
    std::vector<SourceSet> source_sets;  ///< all sources
    std::vector<LightGroup> groups{1};   ///< the first stands for what is in none
};

}  // namespace candelabra
