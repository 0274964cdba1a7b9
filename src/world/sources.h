// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of light sources. A few sources are all evaluated at each point, as in POV-Ray; of many,
// some are sampled by the strategy that also chooses among luminaires. Made by compile(); a Shot
// has the samplers.
#pragma once

#include "light/light.h"
#include "lighting/light_scene.h"
#include "lighting/settings.h"

#include <memory>
#include <vector>

namespace candelabra {

/// Maximum number of sources for the same objects that are all evaluated: they cause no noise then,
/// and one sample per pixel costs hardly more than the four or more that sampled sources take.
inline constexpr std::size_t max_asked_sources = 128;
/// The same if something else is random, so that each pixel has many samples anyway.
inline constexpr std::size_t max_asked_among_samples = 32;

/// Sources that light the same objects.
struct SourceSet {
    std::uint32_t group = 0;            ///< light group; 0: all objects
    std::vector<std::uint32_t> lights;  ///< in WorldLights::sources
    /// The sources, if some are sampled; null if all are evaluated.
    std::shared_ptr<const ChoosableLights> choices = nullptr;
    bool parallel = false;  ///< lights have one direction everywhere, where the choices are

    bool drawn() const { return choices != nullptr; }
    /// Whether a strategy may choose among them and luminaires by one draw.
    bool can_be_joined() const { return drawn() && !parallel && group == 0; }
    /// Returns the receiver for which to query the sampler.
    Receiver asked(const Receiver& point) const {
        return parallel ? Receiver{Vec3(0), point.normal, point.horizon} : point;
    }
};

/// `group_of` has the group of each light; if a group has more than `max_asked` lights, some are
/// sampled.
std::vector<SourceSet> source_sets(std::span<const PointLight> lights,
                                   std::span<const std::uint32_t> group_of, const LightSampler&,
                                   std::size_t max_asked = max_asked_sources);

/// The scene in which a strategy chooses among the sources of a set, given the one in which
/// luminaires are chosen. Precondition: they are drawn.
LightScene light_scene(const SourceSet&, const LightScene&);

}  // namespace candelabra
