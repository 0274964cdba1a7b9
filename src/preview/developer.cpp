// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/developer.h"

#include <chrono>

namespace candelabra {

SnapshotDeveloper::SnapshotDeveloper(std::function<void(ScreenPicture)> shows)
    : shows_(std::move(shows)), thread_([this] { work(); }) {}

SnapshotDeveloper::~SnapshotDeveloper() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (enlarger_.joinable()) enlarger_.join();
}

void SnapshotDeveloper::take(std::shared_ptr<const LightSnapshot> snapshot,
                             std::shared_ptr<const SnapshotContext> context) {
    {
        const std::lock_guard lock(mutex_);
        order_.snapshot = std::move(snapshot);
        order_.context = std::move(context);
        fresh_ = true;
    }
    changed_.notify_all();
}

void SnapshotDeveloper::set(const Look& look) {
    {
        const std::lock_guard lock(mutex_);
        if (order_.look == look) return;
        order_.look = look;
        // A new snapshot with the light of each lamp will follow.
        const bool lacks_lights = look.relights() && order_.snapshot &&
                                  order_.snapshot->lights.empty() && !order_.context->names.empty();
        fresh_ = fresh_ || !lacks_lights;
    }
    changed_.notify_all();
}

SnapshotDeveloper::Order SnapshotDeveloper::order() const {
    const std::lock_guard lock(mutex_);
    return order_;
}

void SnapshotDeveloper::work() {
    constexpr std::chrono::milliseconds rest(400);
    for (;;) {
        Order now;
        {
            std::unique_lock lock(mutex_);
            const auto called = [this] { return ending_ || (fresh_ && order_.snapshot); };
            if (!small_)
                changed_.wait(lock, called);
            else if (!changed_.wait_for(lock, rest, called) && !enlarging_)
                enlarge(order_);
            if (ending_) return;
            if (!called()) continue;
            fresh_ = false;
            ++order_.number;
            now = order_;
            small_ = is_slow(now);
        }
        develop(now, small_ ? reduced(*now.snapshot, quick_step) : *now.snapshot);
    }
}

bool SnapshotDeveloper::is_slow(const Order& now) {
    constexpr int min_edge = 64;
    return now.snapshot->light.width >= quick_step * min_edge && !now.snapshot->view &&
           film_with(now.context->film, now.look).glares;
}

void SnapshotDeveloper::enlarge(const Order& now) {
    if (enlarger_.joinable()) enlarger_.join();
    small_ = false;
    enlarging_ = true;
    enlarger_ = std::thread([this, now] {
        develop(now, *now.snapshot);
        enlarging_ = false;
    });
}

void SnapshotDeveloper::develop(const Order& now, const LightSnapshot& snapshot) {
    const DisplayImage made = display_image(snapshot, *now.context, now.look);
    ScreenPicture picture{
        snapshot.width,
        snapshot.height,
        made.image.width,
        made.image.height,
        now.context->generation,
        snapshot.view_name,
        std::make_shared<const std::string>(screen_bytes(made, now.context->threads))};
    // A newer picture must not be replaced by one that took longer.
    const std::lock_guard lock(showing_);
    if (order().number == now.number) shows_(std::move(picture));
}

std::string SnapshotDeveloper::png() const {
    const Order now = order();
    if (!now.snapshot) return {};
    const DisplayImage shown = display_image(*now.snapshot, *now.context, now.look);
    Diagnostics problems;
    return encode(shown.image, shown.format, problems).value_or("");
}

std::string SnapshotDeveloper::exr() const {
    const Order now = order();
    if (!now.snapshot) return {};
    Diagnostics problems;
    return exr_of(*now.snapshot, *now.context, now.look, problems).value_or("");
}

}  // namespace candelabra
