// SPDX-License-Identifier: GPL-3.0-or-later
// What is decided about a picture before its first sample.
#pragma once

#include "film/schedule.h"
#include "transport/direct_light.h"
#include "transport/sent_light.h"
#include "world/shot.h"

#include <functional>
#include <optional>

namespace candelabra {

/// Parameters of the rendering of a shot, fixed before the first sample and the same for all parts
/// of a picture.
struct RenderPlan {
    const Shot& shot;
    RenderSettings settings;
    ShadowRays shadow_rays;     ///< at each hit
    SentLight sent;             ///< for the shot
    std::uint32_t samples = 1;  ///< per pixel in the first round, or in total
    SampleRule rule;            ///< for further samples

    /// Whether all pixels get exactly the requested number of samples.
    bool is_even() const { return candelabra::is_even(settings, rule); }
};

/// Returns a plan. Traces some pixels where the settings leave the best choice open.
RenderPlan plan_of(const Shot&, const RenderSettings&);
/// The same, but nothing once `cancelled` returns true, which ends the work in the middle of a ray.
/// Several threads call it; it may be empty.
std::optional<RenderPlan> plan_of(const Shot&, const RenderSettings&,
                                  const std::function<bool()>& cancelled);
/// Returns a plan with existing light sent from lamps. Returns nothing once `cancelled` returns
/// true; it is called by several threads and may be empty.
std::optional<RenderPlan> plan_of(const Shot&, const RenderSettings&, const SentLight&,
                                  const std::function<bool()>& cancelled);
/// A plan that traces nothing: one shadow ray at each hit, and reflected luminaires only where the
/// scene asks for them.
RenderPlan plan_without_trials(const Shot&, const RenderSettings&, SentLight);

}  // namespace candelabra
