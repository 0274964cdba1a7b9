// SPDX-License-Identifier: GPL-3.0-or-later
// One frame after the other: a frame is rendered and written when it is asked to render.
#include "app/frame_run.h"

#include "tasks/scene_run.h"

#include <new>

namespace candelabra {

FrameRun::FrameRun(Options options, Console console, Diagnostics problems, std::string unfinished)
    : options_(std::move(options)),
      outer_(std::move(console)),
      problems_(std::move(problems)),
      unfinished_(std::move(unfinished)) {}

FrameRun::~FrameRun() = default;

bool FrameRun::render() {
    if (!ended_) run();
    return rendering_;
}

void FrameRun::run() {
    Console console = outer_;
    console.begins_rendering = [this] { return rendering_ = true; };
    try {
        status_ = run_scene(options_, console, problems_);
    } catch (const std::bad_alloc&) {
        status_ = exit_status::file;
        console.err(no_memory_message);
    }
    ended_ = wound_down_ = true;
}

void FrameRun::speak() {}
bool FrameRun::wait_wound_down() { return rendering_ && status_ == exit_status::done; }
int FrameRun::finish() { return status_; }

}  // namespace candelabra
