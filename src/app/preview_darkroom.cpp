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
        // With the light of each lamp another plate will come.
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
    for (;;) {
        Order now;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return ending_ || (fresh_ && order_.plate); });
            if (ending_) return;
            fresh_ = false;
            now = order_;
        }
        print(now);
    }
}

void Darkroom::print(const Order& now) {
    const auto show = [&](const Plate& plate) {
        const Print print = print_of(plate, *now.frame, now.look);
        shows_({plate.width, plate.height, print.image.width, print.image.height,
                now.frame->generation, plate.view_name,
                std::make_shared<const std::string>(screen_bytes(print, now.frame->threads))});
    };
    constexpr int quick = 4, least_edge = 64;
    constexpr std::chrono::milliseconds rest(400);
    const bool glares = film_with(now.frame->film, now.look).glares && !now.plate->view;
    if (glares && now.plate->light.width >= quick * least_edge) {
        show(reduced(*now.plate, quick));
        std::unique_lock lock(mutex_);
        if (changed_.wait_for(lock, rest, [this] { return ending_ || fresh_; })) return;
    }
    show(*now.plate);
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
