// SPDX-License-Identifier: GPL-3.0-or-later
// How a rendering is watched, stopped and asked for more than colours.
#pragma once

#include "film/picture_shard.h"
#include "transport/aovs.h"
#include "transport/light_ledger.h"

#include <functional>
#include <optional>
#include <span>

namespace candelabra {

/// What keeps the light of each lamp in a picture. Several threads call it, but never at the same
/// time for one block of 8x8 pixels. The calls for a block come in the same order in every run of
/// the picture, whatever its threads and pauses.
class LampSink {
public:
    LampSink() = default;
    virtual ~LampSink() = default;
    LampSink(const LampSink&) = delete;
    LampSink& operator=(const LampSink&) = delete;

    /// Takes the light of lamps in one sample of a pixel; `negative`: to be subtracted.
    virtual void add(int x, int y, std::span<const LampPart>, bool negative) = 0;
    /// Called when all samples of a pass over the region have been added, maybe more than once.
    virtual void passed(const Region&) = 0;
};

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
    LampSink* lamps = nullptr;   ///< gets the light of each lamp; null: nobody does
    Aovs aovs = {};              ///< sums that the film has for them
    /// Pixel around which all passes over the picture begin; unset: anywhere.
    std::optional<Vec2> first = {};
};

}  // namespace candelabra
