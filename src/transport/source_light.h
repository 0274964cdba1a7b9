// SPDX-License-Identifier: GPL-3.0-or-later
// Light of POV-Ray's sources, one by one, or of some of them if they are many and a strategy draws
// among them alone. Grids of lights are treated as in POV-Ray, too.
#pragma once

#include "base/rgb.h"
#include "transport/arrival.h"
#include "world/shot.h"

namespace candelabra {

/// Radiance towards the viewer by one light source, times a weight.
Rgb light_of_source(std::uint32_t number, double weight, const ArrivingLight&, const Key&);

/// Each job has its own: it keeps scratch memory.
class SourceLight {
public:
    /// `rays`: number of choices among many sources.
    SourceLight(const Shot& shot, int rays)
        : samplers_(shot.of_sources), joined_(shot.joined), rays_(rays) {}

    /// Radiance towards the viewer by all light sources that are not drawn with the luminaires; an
    /// unbiased estimate.
    Rgb operator()(const ArrivingLight&, const Key&);

private:
    Rgb drawn(const SourceSet&, const BuiltLightSampler&, const ArrivingLight&, const Key&);

    std::span<const BuiltLightSampler> samplers_;  ///< for each source set
    const SourceSet* joined_;
    int rays_;
    LightSamples samples_;  ///< kept as a member to reuse its memory
};

}  // namespace candelabra
