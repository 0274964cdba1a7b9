// SPDX-License-Identifier: GPL-3.0-or-later
// The light of a world, except for its sky. Filled by flatten() and compile().
#pragma once

#include "lighting/pick.h"
#include "luminaire/luminaire.h"
#include "luminaire/volume.h"
#include "method/photons.h"
#include "world/geometry.h"
#include "world/luminaire_list.h"
#include "world/sources.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Objects that are lit by the same lights.
struct LightGroup {
    std::uint32_t outer = 0;    ///< another group whose lights light the objects as well; 0: none
    bool global_lights = true;  ///< whether lights of no group light its objects
};

/// The restrictions of a light.
struct LightReach {
    std::uint32_t group = 0;             ///< whose objects it lights; 0: all objects
    Handle<Composite> window = nullptr;  ///< opening through which it lights; null: none
    PhotonWays photons = {};             ///< the light's photon settings
    bool photons_of_grid = false;        ///< whether they start from its whole grid
};

/// A solid whose media light the scene.
struct GlowingVolume {
    PrimitiveIndex primitive = no_primitive;  ///< one of its primitives
    LightIndex box = 0;                       ///< the first of its boxes, as visit() counts
};

/// All lights except for the sky.
struct WorldLights {
    LuminaireList luminaires;
    /// Per primitive that belongs to no instance: index in luminaires, or no_primitive; empty if
    /// there are none. World::luminaire_of() knows all of them.
    std::vector<std::uint32_t> luminaire_of;
    std::vector<MediaBox> media;  ///< boxes of which the volumes consist
    std::vector<GlowingVolume> volumes;
    /// Whether media glow within solids only, and rays may pass between the inside and the outside
    /// of a solid other than through its surface: only a walk along a ray then tells which media it
    /// sees.
    bool glow_beside_openings = false;
    std::vector<PointLight> sources;
    std::vector<LightReach> reach;       ///< for each source
    std::vector<SourceSet> source_sets;  ///< cover all sources
    std::vector<LightGroup> groups{1};   ///< the first one stands for objects in no group

    /// Number of luminaires and boxes of media, which are counted in this order.
    std::size_t glowing() const { return luminaires.size() + media.size(); }
    bool any_glowing() const { return glowing() > 0; }
    /// Calls use(luminaire) or use(box) for the one of that number.
    template <class Use>
    decltype(auto) visit(LightIndex number, const Use& use) const {
        if (number < luminaires.size()) return use(*luminaires[number]);
        return use(media[number - luminaires.size()]);
    }
    template <class Use>
    void for_each_glowing(const Use& use) const {
        luminaires.for_each(use);
        for (const MediaBox& each : media) use(each);
    }
};

}  // namespace candelabra
