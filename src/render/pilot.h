// SPDX-License-Identifier: GPL-3.0-or-later
// What the settings leave open, and tracing some pixels before the picture finds: the number of
// shadow rays at each hit, and whether reflected luminaires pay. It is the same for all parts of
// the picture.
#pragma once

#include "scene/settings.h"
#include "transport/integrator.h"

#include <cstdint>
#include <functional>

namespace candelabra {

/// Variances of one sample of a pixel, summed over all pixels tried.
struct PilotNoise {
    double of_light = 0;  ///< due to the shadow rays of one hit
    /// Variance due to the hits of a pixel's camera rays, were their light known exactly.
    double of_camera = 0;
    double shown = 0;        ///< of_light in display values
    int places = 0;          ///< number of places on the picture that were summed
    HitNoise of_hits;        ///< as expected by their cells
    std::uint64_t rays = 0;  ///< that were followed for four samples of each place
};
/// Measures the noise of some pixels. `sent`: light for the shot; if empty, the pilot computes it
/// where needed. `cancelled`: called by several threads, may be empty; once it returns true, the
/// result is meaningless. `rays`: at each hit.
PilotNoise pilot_noise(const Shot&, const RenderSettings&,
                       const std::optional<SentLight>& sent = {},
                       const std::function<bool()>& cancelled = {}, const ShadowRays& rays = {});

/// Whether the light is almost free of noise, so that pixels need only the samples that their
/// contrast requires.
bool is_quiet(const PilotNoise&);

/// Whether paths alone make less noise in the same time than reflected luminaires. `sending`: cost
/// of making these and of choosing among them, in rays for each sample of a pixel. Work is counted,
/// so that the answer does not depend on the machine.
bool paths_pay(const PilotNoise& reflected, const PilotNoise& paths, double sending);

/// Returns the number of shadow rays with the least noise for a given time: the square root of
/// (cost of a camera ray over that of a shadow ray) times (variance due to light over variance due
/// to the camera), from 1 to 4 times the number of draws that one draw stands for.
int best_shadow_rays(const PilotNoise&, int draws = 1);

/// Whether all samples of a pixel begin with the same ray, so that the camera makes no noise.
bool has_equal_rays(const Shot&, const RenderSettings&);

/// Whether more shadow rays at each hit make less noise in the same time, where samples of a pixel
/// begin with the same ray. Work is counted, as in paths_pay(). Precondition: as many samples were
/// followed for both.
bool more_rays_pay(const PilotNoise& few, const PilotNoise& many);

/// Results of the pilot. The number of shadow rays at each hit is that of the settings, or else the
/// best one for hits of usual noise. It does not depend on the number of samples, so that pictures
/// can be continued.
struct Pilot {
    ShadowRays shadow_rays;
    /// Whether there are so many that two samples of a pixel make less noise than four usually do.
    bool many_rays = false;
    bool quiet = false;  ///< see is_quiet(); false if no pixels were tried
    /// Whether paths alone make less noise in the same time than reflected luminaires, which the
    /// scene leaves open.
    bool by_paths = false;
};
Pilot pilot(const Shot&, const RenderSettings&, const std::optional<SentLight>& sent = {},
            const std::function<bool()>& cancelled = {});

}  // namespace candelabra
