// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of an integrator besides radiance.
#pragma once

#include "transport/direct_light.h"
#include "transport/sent_light.h"

namespace candelabra {

struct Tracing {
    ShadowRays shadow_rays = {};  ///< at each hit
    bool counts_lights = false;   ///< one by one
    SentLight sent = {};          ///< of the world; none: the integrator makes some
    bool clear_sky = false;       ///< what is behind everything may be clear, as in POV-Ray's +UA
};

}  // namespace candelabra
