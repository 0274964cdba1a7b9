// SPDX-License-Identifier: GPL-3.0-or-later
// How the work of a pixel is divided between camera rays and shadow rays, when the run does not
// say. Found by tracing some pixels before the picture is made; the same for every part of it.
#pragma once

#include "scene/settings.h"
#include "transport/integrator.h"

#include <functional>

namespace candelabra {

/// Variances of one sample of a pixel, over all pixels that were tried.
struct PilotNoise {
    double of_light = 0;   ///< by the shadow rays of one hit
    double of_camera = 0;  ///< by what camera rays of one pixel meet, were its light known
    double shown = 0;      ///< of_light as it is displayed
    int places = 0;        ///< on the picture, which these are sums over
    HitNoise of_hits;      ///< as their cells expect it
};
/// `sent`: light of the world; none: the pilot makes it, where there is some. `cancelled`: asked by
/// several threads, may be empty; once it is true, the answer means nothing.
PilotNoise pilot_noise(const World&, const RenderSettings&, const SentLight& sent = {},
                       const std::function<bool()>& cancelled = {});

/// Whether the light is nearly as quiet as if nothing were left to chance, so that pixels need no
/// more samples than their contrast asks for.
bool is_quiet(const PilotNoise&);

/// Shadow rays that make the least noise in a given time: the root of (cost of a camera ray over
/// that of a shadow ray) times (variance by light over variance by the camera), from 1 to 4. More
/// are hardly better where camera rays make no noise at all.
int best_shadow_rays(const PilotNoise&);

/// What the settings say at each hit, or the best number for hits of usual noise. It does not
/// depend on the number of samples, so that pictures can be continued.
struct Pilot {
    ShadowRays shadow_rays;
    bool quiet = false;  ///< see is_quiet(); false where no pixels were tried
};
Pilot pilot(const World&, const RenderSettings&, const SentLight& sent = {},
            const std::function<bool()>& cancelled = {});

}  // namespace candelabra
