// SPDX-License-Identifier: GPL-3.0-or-later
// How a rendering is watched, stopped and asked for more than colours.
#pragma once

#include "transport/aovs.h"

#include <functional>
#include <optional>

namespace candelabra {

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

}  // namespace candelabra
