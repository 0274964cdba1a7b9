// SPDX-License-Identifier: GPL-3.0-or-later
// Light that arrives at a layer. Luminaires, the sky, light sources, reflected luminaires and
// photons find it in their own ways; here all of it becomes radiance towards the layer's viewer.
#pragma once

#include "base/rgb.h"
#include "transport/light_ledger.h"
#include "transport/lit_layer.h"

namespace candelabra {

/// An estimate of light from one direction.
struct Arrival {
    Lamp lamp;
    /// Factor on its light: the layer's response to light from there, over the expected number or
    /// the pdf of such estimates. Light from one steradian of radiance 1 is light of colour 1/pi.
    Rgb weight;
    Rgb light;  ///< radiance, or the colour of a source's light, that is left at the layer
    std::uint64_t rays = 0;  ///< towards the lamp
};

/// The receiver of arrivals: a layer, and the ledger that records them.
struct ArrivingLight {
    const World& world;
    const LitLayer& layer;
    bool photons;  ///< photons bring the light that passes through their targets
    LightLedger& ledger;

    /// Returns the radiance towards the viewer by one arrival, which it records.
    Rgb operator()(const Arrival& arrival) const {
        const Rgb radiance = arrival.weight * layer.counted(arrival.light);
        ledger.add_reflected(arrival.lamp, radiance, layer.throughput, arrival.rays);
        return radiance;
    }
};

}  // namespace candelabra
