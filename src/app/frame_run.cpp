// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_run.h"

#include "tasks/scene_run.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <system_error>

namespace candelabra {

FrameRun::FrameRun(Options options, Console console, Diagnostics problems, std::string unfinished)
    : options_(std::move(options)),
      outer_(std::move(console)),
      problems_(std::move(problems)),
      unfinished_(std::move(unfinished)),
      thread_([this] { run(); }) {}

FrameRun::~FrameRun() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        unwanted_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void FrameRun::run() {
    Console console = outer_;
    console.out = [&](std::string_view text) {
        hear([this, text = std::string(text)] { outer_.out(text); });
    };
    console.err = [&](std::string_view text) {
        hear([this, text = std::string(text)] { outer_.err(text); });
    };
    if (outer_.sorted)
        console.sorted = [&](Stream stream, std::string_view text, std::string_view plain) {
            hear([this, stream, text = std::string(text), plain = std::string(plain)] {
                outer_.sorted(stream, text, plain);
            });
        };
    console.interrupts.take = [&] {
        if (unwanted_) return Interrupt::stop;
        return outer_.interrupts.take ? outer_.interrupts.take() : Interrupt::none;
    };
    console.files_read = [&](const std::vector<ReadFile>& files) {
        std::error_code none;
        for (const ReadFile& file : files)
            if (!unfinished_.empty() && std::filesystem::equivalent(file.path, unfinished_, none))
                unwanted_ = true;
    };
    console.begins_rendering = [this] { return begin_rendering(); };
    console.winds_down = [this] { wind_down(); };
    console.ends_rendering = [this] { end_rendering(); };
    int status = exit_status::file;
    try {
        status = run_scene(options_, console, problems_);
    } catch (const std::bad_alloc&) {
        console.err(no_memory_message);
    }
    const std::lock_guard lock(mutex_);
    status_ = status;
    ended_ = true;
    changed_.notify_all();
}

/// Called by the run. Returns false if it shall stop.
bool FrameRun::begin_rendering() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return may_render_ || unwanted_; });
    if (unwanted_) return false;
    rendering_ = true;
    changed_.notify_all();
    return true;
}

/// Called by the run when it leaves cores idle.
void FrameRun::wind_down() {
    const std::lock_guard lock(mutex_);
    wound_down_ = true;
    changed_.notify_all();
}

/// Called by the run. Waits, since pictures are written in frame order.
void FrameRun::end_rendering() {
    wind_down();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return speaking_ || unwanted_; });
}

void FrameRun::hear(std::function<void()> said) {
    const std::lock_guard lock(mutex_);
    if (speaking_)
        said();
    else
        unheard_.push_back(std::move(said));
}

bool FrameRun::render() {
    std::unique_lock lock(mutex_);
    may_render_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return rendering_ || ended_; });
    return rendering_;
}

void FrameRun::speak() {
    const std::lock_guard lock(mutex_);
    for (const auto& said : unheard_) said();
    unheard_.clear();
    speaking_ = true;
    changed_.notify_all();
}

bool FrameRun::wait_wound_down() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return wound_down_ || ended_; });
    return wound_down_;
}

int FrameRun::finish() {
    if (thread_.joinable()) thread_.join();
    return status_;
}

}  // namespace candelabra
