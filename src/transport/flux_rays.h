// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that leave light sources with a flux in all their directions, wherever they lead: the
// beginnings of paths in balances of light. (SourceRays aims at what a picture shows.)
#pragma once

#include "base/weighted_index.h"
#include "transport/path.h"
#include "world/world.h"

#include <cstdint>
#include <optional>

namespace candelabra {

/// Whether a source has a flux that goes where paths go: its light falls with the square of the
/// distance, is stopped by surfaces, and is for all objects.
bool sends_flux(const World&, std::uint32_t source);

struct FluxRay {
    std::uint32_t source;  ///< in WorldLights::sources
    PathState path;        ///< its ray begins in the source; its throughput is 1
    /// Colour of light times area: the mean over many rays is the power of all sources over pi.
    Rgb power;
};

class FluxRays {
public:
    /// The world must outlive this.
    explicit FluxRays(const World&);

    /// The luminance times area of all sources with a flux, as if windows kept back none of it.
    double light() const { return light_; }

    /// Draws a ray; nothing if its window is in the way. Precondition: light() is above 0.
    std::optional<FluxRay> draw(const Key&) const;

private:
    const World& world_;
    double light_ = 0;
    WeightedIndex places_;  ///< sources, weighted by their light
};

}  // namespace candelabra
