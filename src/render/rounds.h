// SPDX-License-Identifier: GPL-3.0-or-later
// The rounds of a picture, each in passes over its tiles, by several threads.
#pragma once

#include "render/hooks.h"
#include "render/interruption.h"
#include "render/plan.h"
#include "render/sample.h"
#include "transport/light_ledger.h"

#include <atomic>
#include <cstdint>
#include <mutex>

namespace candelabra {

class Rounds {
public:
    Rounds(const RenderPlan& plan, RenderState& state, const RenderHooks& hooks)
        : plan_(plan),
          state_(state),
          hooks_(hooks),
          fresh_tracer_(plan, hooks, state.film),
          interruption_(hooks) {}

    /// Runs all rounds. Returns false if they were stopped.
    bool run();

    const LightLedger& rays() const { return rays_; }

private:
    void run_round();
    void prepare(std::uint32_t from, std::uint32_t to);
    void over_tiles(std::uint32_t level, bool ends_round);
    std::uint64_t make_tile(const Region&, std::uint32_t level);
    void wind_down();
    bool wants(const Region&, std::uint32_t level) const;
    void pass_lamps(const Region&, std::uint32_t level) const;
    std::uint32_t level_after(std::uint32_t level, std::uint32_t most) const;
    double overall(double share_of_round) const;

    const RenderPlan& plan_;
    RenderState& state_;
    const RenderHooks& hooks_;
    const SampleTracer fresh_tracer_;  ///< each tile works with a copy
    Interruption interruption_;
    std::mutex mutex_;
    LightLedger rays_;
    std::uint64_t wanted_ = 0;  ///< samples in total so far
    std::atomic<std::uint64_t> done_ = 0;
    std::atomic<std::uint64_t> held_ = 0;  ///< pixels of tiles since the film let go of its pages
    bool winds_down_ = false;  ///< set when the last tile of a round begins
};

}  // namespace candelabra
