// SPDX-License-Identifier: GPL-3.0-or-later
// Makes one picture and loses nothing: begins it or goes on from a state, writes states at
// intervals and when signals ask, and says how it ended. The caller writes the picture.
#pragma once

#include "app/checkpoint.h"
#include "app/interrupt.h"
#include "app/output.h"
#include "app/progress.h"
#include "render/render.h"

namespace candelabra {

enum class JobEnd {
    finished,  ///< the picture is complete
    stopped,   ///< a signal came; the state was kept, or there is an error in the diagnostics
};

/// What a job makes and where it may keep its state.
struct JobPlan {
    const Options& options;
    Identity identity;
    std::string picture;         ///< path of the picture; its state lies beside it
    std::optional<Shard> shard;  ///< nothing: the whole picture
    /// See RenderHooks; not called when the time is limited, which is for this picture alone.
    std::function<void()> winds_down;
};

/// Beside which a state lies: the picture's name and, of a shard, its number.
std::string state_path(const JobPlan&);
std::string state_path(const std::string& picture, const std::optional<Shard>&);

/// As many samples as the time allows, where nothing else says how many.
RenderSettings timed(const Options&);

class RenderJob {
public:
    RenderJob(JobPlan, const World&, const Interrupts&, Diagnostics&);

    /// Begins the picture, or reads the state that it goes on from. False after a report.
    bool prepare();

    /// Called once, after that. The clock gives seconds.
    JobEnd run(Progress&, const std::function<double()>& clock);

    const Film& film() const { return checkpoint_.state.film; }
    const LightLedger& rays() const { return rays_; }
    /// Samples of a pixel of the whole picture, when that number is even.
    int samples() const { return static_cast<int>(checkpoint_.all_samples); }
    /// Whether there is a place for a state.
    bool can_keep() const;
    /// Writes the state, or takes an old one away: what is left when the picture is there.
    void leave_state(bool keep);

private:
    void begin();
    bool fits(const Checkpoint& old);
    bool save(Diagnostics&);
    void save_and_go_on();
    Interrupt work(Progress&, const std::function<double()>& clock);

    JobPlan plan_;
    Aovs extras_;
    RenderPlan rendering_;
    const Interrupts& interrupts_;
    Diagnostics& diagnostics_;
    Checkpoint checkpoint_;
    LightLedger rays_;
    double begun_ = 0;
    double deadline_ = 0;
    double save_at_ = 0;
};

}  // namespace candelabra
