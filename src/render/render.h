// SPDX-License-Identifier: GPL-3.0-or-later
// World to picture. Each sample is a pure function of world, settings, seed, pixel and its number,
// and sums are exact, so the picture has the same bytes for any number of threads, and however
// often the work is stopped and continued.
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

/// How a world is rendered, which is settled before the first sample and the same for all parts of
/// a picture.
struct RenderPlan {
    const World& world;
    RenderSettings settings;
    ShadowRays shadow_rays;     ///< at each hit
    SentLight sent;             ///< of the world
    std::uint32_t samples = 1;  ///< of each pixel in the first round, or altogether
    SampleRule rule;            ///< for those that follow

    /// Whether all pixels get the number of samples that is asked for.
    bool is_even() const { return candelabra::is_even(settings, rule); }
};

/// Traces some pixels where the settings leave open what pays best.
RenderPlan plan_of(const World&, const RenderSettings&);
/// The same where the light that is sent from lamps is there already. Nothing once `cancelled`,
/// which several threads ask, is true; it may be empty.
std::optional<RenderPlan> plan_of(const World&, const RenderSettings&, const SentLight&,
                                  const std::function<bool()>& cancelled);

/// What the caller may want to know while a picture is made. All may be called from several
/// threads, and may be empty.
struct RenderHooks {
    std::function<void(double fraction)> progress;  ///< of the whole picture
    std::function<bool()> cancelled;                ///< true: stop within some samples
    /// Called once, when a round has nothing left to begin and the first core becomes free.
    std::function<void()> winds_down;
    bool counts_lights = false;  ///< fills LightLedger::lights
    Aovs aovs = {};              ///< the film has sums for them
    /// The pixel around which all passes over the picture begin; nothing: no matter where.
    std::optional<Vec2> first = {};
};

struct Rendering {
    Image image;
    LightLedger rays;
};

/// A whole picture at once.
Rendering render(const World&, const RenderSettings&, const RenderHooks& = {});

/// Goes on with a picture until it is finished; false when the hook has stopped it. Adds to the
/// counts.
bool advance(const RenderPlan&, RenderState&, LightLedger&, const RenderHooks& = {});

}  // namespace candelabra
