// SPDX-License-Identifier: GPL-3.0-or-later
// Options of an integrator.
#pragma once

#include "transport/direct_light.h"
#include "transport/sent_light.h"

#include <cstdint>
#include <optional>

namespace candelabra {

struct Tracing {
    ShadowRays shadow_rays = {};         ///< at each hit
    bool counts_lights = false;          ///< separately for each statement
    bool keeps_lamps = false;            ///< light of each lamp in a sample, see LampPart
    std::optional<SentLight> sent = {};  ///< unset: the integrator makes that of the shot
    bool clear_sky = false;              ///< the background may be clear, as with POV-Ray's +UA
    bool from_anywhere = false;          ///< rays begin at other places than the camera's
    /// Maximum number of rays that are followed for one camera ray, without shadow rays. What is
    /// left then counts as black.
    std::uint64_t max_rays = 1'000'000;
};

}  // namespace candelabra
