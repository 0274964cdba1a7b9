// SPDX-License-Identifier: GPL-3.0-or-later
// How a picture that is being made stops.
#pragma once

#include "base/work_watch.h"
#include "render/hooks.h"

#include <atomic>
#include <functional>

namespace candelabra {

/// Whether the work is to stop. Any thread may ask, and stops all of them.
class Interruption {
public:
    explicit Interruption(const RenderHooks& hooks) : hooks_(hooks) {}

    bool stopped() const { return stopped_; }

    /// Asks the hooks, which costs as much as a short ray.
    bool ask() {
        if (!stopped_ && hooks_.cancelled && hooks_.cancelled()) stopped_ = true;
        return stopped_;
    }

    /// Calls make() and returns its result. If it is ended in the middle of a sample, the work
    /// stops, and the result is 0.
    template <class Make>
    auto watched(const Make& make) -> decltype(make()) {
        try {
            const WorkWatch watch(ended_, WorkWatch::Asks::everywhere);
            return make();
        } catch (const WorkEnded&) {
            stopped_ = true;
            return 0;
        }
    }

private:
    std::function<bool()> when_ended() {
        if (!hooks_.ended) return {};
        return [this] { return stopped_ || hooks_.ended(); };
    }

    const RenderHooks& hooks_;
    std::atomic<bool> stopped_ = false;
    /// Empty if nobody may end samples.
    const std::function<bool()> ended_ = when_ended();
};

}  // namespace candelabra
