// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of an integrator besides radiance.
#pragma once

#include "transport/direct_light.h"

namespace candelabra {

struct Tracing {
    ShadowRays shadow_rays = {};                 ///< at each hit
    bool counts_lights = false;                  ///< one by one
    std::shared_ptr<Photons> photons = nullptr;  ///< of the world; null: the integrator makes some
    bool clear_sky = false;  ///< what is behind everything may be clear, as in POV-Ray's +UA
};

}  // namespace candelabra
