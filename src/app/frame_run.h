// SPDX-License-Identifier: GPL-3.0-or-later
// One frame of an animation on a thread of its own, so that it can be prepared while the frame
// before it is rendered, and written while the next one is. A frame begins to be rendered when the
// one before leaves cores free, and what each says comes in the order of the frames. Called by the
// animation.
#pragma once

#include "app/console.h"
#include "app/options.h"

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
    /// Stops the work if it is not done, and waits for its end.
    ~FrameRun();

    /// The frame before leaves cores free: this one may be rendered. False when it has ended
    /// without that: there was an error, or nothing to render.
    bool render();
    /// The frame before has ended: what this one says is heard from now on.
    void speak();
    /// Waits until there are cores that it has no work for; it need not be complete yet. False: it
    /// has ended without that.
    bool wait_wound_down();
    /// Waits for the end; gives the exit status.
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
    std::atomic<bool> unwanted_ = false;          ///< it shall end
    std::vector<std::function<void()>> unheard_;  ///< what is said before it may speak
    int status_ = exit_status::done;
    std::thread thread_;
};

}  // namespace candelabra
