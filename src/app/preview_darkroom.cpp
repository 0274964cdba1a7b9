// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_darkroom.h"

#include <chrono>

namespace candelabra {

Darkroom::Darkroom(std::function<void(ScreenPicture)> shows)
    : shows_(std::move(shows)), thread_([this] { work(); }) {}

Darkroom::~Darkroom() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (enlarger_.joinable()) enlarger_.join();
}

void Darkroom::take(std::shared_ptr<const Plate> plate, std::shared_ptr<const PlateFrame> frame) {
    {
        const std::lock_guard lock(mutex_);
        order_.plate = std::move(plate);
        order_.frame = std::move(frame);
        fresh_ = true;
    }
    changed_.notify_all();
}

void Darkroom::set(const Look& look) {
    {
        const std::lock_guard lock(mutex_);
        if (order_.look == look) return;
        order_.look = look;
        // A new plate with the light of each lamp will follow.
        const bool lacks_lights = look.relights() && order_.plate && order_.plate->lights.empty() &&
                                  !order_.frame->names.empty();
        fresh_ = fresh_ || !lacks_lights;
    }
    changed_.notify_all();
}

Darkroom::Order Darkroom::order() const {
    const std::lock_guard lock(mutex_);
    return order_;
}

void Darkroom::work() {
    constexpr std::chrono::milliseconds rest(400);
    for (;;) {
        Order now;
        {
            std::unique_lock lock(mutex_);
            const auto called = [this] { return ending_ || (fresh_ && order_.plate); };
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
        print(now, small_ ? reduced(*now.plate, quick_step) : *now.plate);
    }
}

bool Darkroom::is_slow(const Order& now) {
    constexpr int min_edge = 64;
    return now.plate->light.width >= quick_step * min_edge && !now.plate->view &&
           film_with(now.frame->film, now.look).glares;
}

void Darkroom::enlarge(const Order& now) {
    if (enlarger_.joinable()) enlarger_.join();
    small_ = false;
    enlarging_ = true;
    enlarger_ = std::thread([this, now] {
        print(now, *now.plate);
        enlarging_ = false;
    });
}

void Darkroom::print(const Order& now, const Plate& plate) {
    const Print made = print_of(plate, *now.frame, now.look);
    ScreenPicture picture{
        plate.width,
        plate.height,
        made.image.width,
        made.image.height,
        now.frame->generation,
        plate.view_name,
        std::make_shared<const std::string>(screen_bytes(made, now.frame->threads))};
    // A newer picture must not be replaced by one that took longer.
    const std::lock_guard lock(showing_);
    if (order().number == now.number) shows_(std::move(picture));
}

std::string Darkroom::png() const {
    const Order now = order();
    if (!now.plate) return {};
    const Print print = print_of(*now.plate, *now.frame, now.look);
    Diagnostics problems;
    return encode(print.image, print.format, problems).value_or("");
}

std::string Darkroom::exr() const {
    const Order now = order();
    if (!now.plate) return {};
    Diagnostics problems;
    return exr_of(*now.plate, *now.frame, now.look, problems).value_or("");
}

}  // namespace candelabra
