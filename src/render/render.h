// SPDX-License-Identifier: GPL-3.0-or-later
// Renders a world to a picture. Each sample is a pure function of world, settings, seed, pixel and
// sample number, and sums are exact. So the picture has the same bytes for any number of threads,
// and however often the work is stopped and continued.
#pragma once

#include "film/schedule.h"
#include "transport/aovs.h"
#include "transport/direct_light.h"
#include "transport/light_ledger.h"
#include "transport/sent_light.h"
#include "world/world.h"

#include <functional>
#include <optional>

namespace candelabra {

/// Parameters of the rendering of a world, fixed before the first sample and the same for all parts
/// of a picture.
struct RenderPlan {
    const World& world;
    RenderSettings settings;
    ShadowRays shadow_rays;     ///< at each hit
    SentLight sent;             ///< of the world
    std::uint32_t samples = 1;  ///< per pixel in the first round, or in total
    SampleRule rule;            ///< for further samples

    /// Whether all pixels get exactly the requested number of samples.
    bool is_even() const { return candelabra::is_even(settings, rule); }
};

/// Returns a plan. Traces some pixels where the settings leave the best choice open.
RenderPlan plan_of(const World&, const RenderSettings&);
/// Returns a plan with existing light sent from lamps. Returns nothing once `cancelled` returns
/// true; it is called by several threads and may be empty.
std::optional<RenderPlan> plan_of(const World&, const RenderSettings&, const SentLight&,
                                  const std::function<bool()>& cancelled);

/// Callbacks and options for a rendering. The functions may be called by several threads, and may
/// be empty.
struct RenderHooks {
    std::function<void(double fraction)> progress;  ///< of the whole picture
    std::function<bool()> cancelled;                ///< true: stop within a few samples
    /// True: stop at once, and lose the samples under way. It is asked a hundred times a second.
    std::function<bool()> ended = {};
    /// Called once, when a round has no further work to start and the first core becomes idle.
    std::function<void()> winds_down;
    /// Called for each sample that ended at Tracing::max_rays, with its pixel.
    std::function<void(int x, int y)> cut = {};
    bool counts_lights = false;  ///< fills LightLedger::lights
    Aovs aovs = {};              ///< sums that the film has for them
    /// Pixel around which all passes over the picture begin; unset: anywhere.
    std::optional<Vec2> first = {};
};

struct Rendering {
    Image image;
    LightLedger rays;
};

/// Renders a whole picture.
Rendering render(const World&, const RenderSettings&, const RenderHooks& = {});

/// Continues a picture until it is finished. Returns false if `cancelled` has stopped it. Adds to
/// the ledger.
bool advance(const RenderPlan&, RenderState&, LightLedger&, const RenderHooks& = {});

}  // namespace candelabra
