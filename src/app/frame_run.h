// SPDX-License-Identifier: GPL-3.0-or-later
// Renders one frame of an animation on its own thread, so that it can be prepared while the
// previous frame is rendered and written while the next one is. A frame begins to render when the
// previous one leaves cores free. The output of frames appears in frame order. Used by the
// animation.
#pragma once

#include "console/console.h"
#include "options/options.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace candelabra {

class FrameRun {
public:
    /// Begins to prepare the frame. `unfinished`: a picture that another frame is still making; a
    /// frame that reads it cannot be prepared yet.
    FrameRun(Options options, Console console, Diagnostics problems, std::string unfinished = {});
    FrameRun(const FrameRun&) = delete;
    FrameRun& operator=(const FrameRun&) = delete;
    /// Stops unfinished work and waits for its end.
    ~FrameRun();

    /// Lets the frame render, since the previous one leaves cores free. Returns false if the frame
    /// has ended without rendering: after an error, or with nothing to render.
    bool render();
    /// Releases the output of this frame, since the previous one has ended.
    void speak();
    /// Waits until the frame leaves cores idle; it need not be complete yet. Returns false if it
    /// has ended without that.
    bool wait_wound_down();
    /// Waits for the end. Returns the exit status.
    int finish();

    const Options& options() const { return options_; }

private:
    void run();
    bool begin_rendering();
    void wind_down();
    void end_rendering();
    void hear(std::function<void()> said);

    Options options_;
    Console outer_;
    Diagnostics problems_;
    std::string unfinished_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool may_render_ = false, rendering_ = false, wound_down_ = false, ended_ = false,
         speaking_ = false;
    std::atomic<bool> unwanted_ = false;          ///< the run shall stop
    std::vector<std::function<void()>> unheard_;  ///< output that waits for speak()
    int status_ = exit_status::done;
    std::thread thread_;
};

}  // namespace candelabra
