// SPDX-License-Identifier: GPL-3.0-or-later
// Renders one picture without loss of work: starts it or continues from a state, writes states at
// intervals and on signals, and returns how it ended. The caller writes the picture.
#pragma once

#include "base/zeroed_pages.h"
#include "console/interrupt.h"
#include "console/progress.h"
#include "options/output.h"
#include "production/checkpoint.h"
#include "render/render.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace candelabra {

enum class JobEnd {
    finished,  ///< the picture is complete
    stopped,   ///< a signal came; the state was saved, or the diagnostics have an error
};

/// The picture of a job, and the location of its state.
struct JobPlan {
    const Options& options;
    Identity identity;
    std::string picture;         ///< path of the picture, which its state lies beside
    std::optional<Shard> shard;  ///< unset: the whole picture
    /// See RenderHooks. Not called if the time is limited, since the limit is for this picture
    /// alone.
    std::function<void()> winds_down;
    /// Bytes of memory for each pixel that writing the picture takes at the end.
    std::size_t writing = 0;
    /// What keeps the light of lamps, if anything does, and the memory that it may take.
    struct Lamps {
        LampSink* sink = nullptr;  ///< see RenderHooks
        std::uint64_t memory = 0;  ///< in bytes
        /// Its bytes for a state of the picture, and what goes on from these; false: it cannot.
        std::function<std::string()> state = {};
        std::function<bool(std::string_view)> go_on = {};
    };
    Lamps lamps = {};
};

/// Returns the path of a state: the picture's name with the number of a shard, if any.
std::string state_path(const JobPlan&);
std::string state_path(const std::string& picture, const std::optional<Shard>&);

/// Returns the settings; if only the time is limited, the number of samples is practically
/// unlimited.
RenderSettings timed(const Options&);

class RenderJob {
public:
    /// Sends the first light from lamps and traces some pixels, which may take a while.
    RenderJob(JobPlan, const Shot&, const Interrupts&, Diagnostics&);

    /// Whether it was asked to stop in the constructor. Then only can_keep() may be called.
    bool stopped() const { return !rendering_; }

    /// Starts the picture, or reads the state to continue from. Returns false after an error has
    /// been reported.
    bool prepare();

    /// Renders the picture. Call it once, after prepare(). The clock returns seconds.
    JobEnd run(Progress&, const std::function<double()>& clock);

    const Film& film() const { return checkpoint_.state.film; }
    const LightLedger& rays() const { return rays_; }
    /// Samples per pixel of the whole picture, if uniform.
    int samples() const { return static_cast<int>(checkpoint_.all_samples); }
    /// Whether a state can be stored beside the picture. After prepare(), the memory also counts.
    bool can_keep() const;
    /// Writes the final state or removes an old one. Call it when the picture has been written.
    void leave_state(bool keep);

private:
    bool has_room();
    bool has_room_for_state(std::uint64_t held, std::uint64_t limit);
    std::optional<ZeroedPages> pages_in_file(std::size_t bytes) const;
    void begin();
    bool fits(const Checkpoint& old);
    bool can_keep_lamps(const Checkpoint* old);
    bool save(Diagnostics&);
    void save_and_go_on();
    Interrupt work(Progress&, const std::function<double()>& clock);
    /// Warns of samples that ended at Tracing::max_rays.
    void warn_of_cut();

    JobPlan plan_;
    Aovs extras_;
    std::atomic<bool> asked_to_save_ = false;  ///< while the picture was planned
    std::optional<RenderPlan> rendering_;      ///< none: it was asked to stop before
    const Interrupts& interrupts_;
    Diagnostics& diagnostics_;
    Checkpoint checkpoint_;
    std::optional<ZeroedPages> pages_;  ///< for the film, if it is too large for the memory
    bool state_fits_ = true;            ///< the memory holds a state while it is written
    LightLedger rays_;
    std::mutex cut_mutex_;
    std::uint64_t cut_samples_ = 0;
    std::pair<int, int> first_cut_;  ///< row and column of the uppermost of them
    double begun_ = 0;
    double deadline_ = 0;
    double save_at_ = 0;
};

}  // namespace candelabra
