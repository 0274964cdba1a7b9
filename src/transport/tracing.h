// SPDX-License-Identifier: GPL-3.0-or-later
// Options of an integrator.
#pragma once

#include "transport/direct_light.h"
#include "transport/sent_light.h"

namespace candelabra {

struct Tracing {
    ShadowRays shadow_rays = {};  ///< at each hit
    bool counts_lights = false;   ///< separately for each statement
    SentLight sent = {};          ///< of the world; none: the integrator makes it
    bool clear_sky = false;       ///< the background may be clear, as with POV-Ray's +UA
};

}  // namespace candelabra
