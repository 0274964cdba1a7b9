// SPDX-License-Identifier: GPL-3.0-or-later
// Light sources in the sets in which they are asked. A few are all asked at each point, as POV-Ray
// does; of many some are chosen, by the sampler that chooses among luminaires. Made by compile().
#pragma once

#include "light/light.h"
#include "lighting/sampler.h"

#include <vector>

namespace candelabra {

/// Up to so many sources that light the same objects are all asked: then they make no noise, and
/// one sample a pixel is hardly dearer than the four that chosen ones take at least.
inline constexpr std::size_t max_asked_sources = 128;
/// The same where something else is left to chance, and each pixel has many samples anyway.
inline constexpr std::size_t max_asked_among_samples = 32;

/// Sources that light the same objects.
struct SourceSet {
    std::uint32_t group = 0;            ///< of lights; 0: of all objects
    std::vector<std::uint32_t> lights;  ///< in WorldLights::sources
    /// One for each when some are chosen; none when all are asked.
    std::vector<Luminaire> emitters = {};
    bool parallel = false;  ///< light has the same direction everywhere: that is where emitters are
    BuiltLightSampler sampler = {};

    bool drawn() const { return !emitters.empty(); }
    /// The point for which the sampler is to be asked.
    Receiver asked(const Receiver& point) const {
        return parallel ? Receiver{Vec3(0), point.normal, point.horizon} : point;
    }
};

/// `group_of` has the group of each light; of more than `max_asked` in one, some are chosen. The
/// boxes and planes of the scene are where points to be lit are.
std::vector<SourceSet> source_sets(std::span<const Light> lights,
                                   std::span<const std::uint32_t> group_of, const LightSampler&,
                                   const LightScene&, std::size_t max_asked = max_asked_sources);

}  // namespace candelabra
