// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lamp_draw.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Share of the looks that lamps get by their solid angle alone, as they may reflect more light
/// than they emit.
constexpr double by_size = 0.2;
/// Least chance of what lies aside, of that on the line of sight.
constexpr double aside = 0.01;

float single(double x) { return static_cast<float>(x); }

}  // namespace

LampDraw::LampDraw(const LuminaireList& all, std::size_t most) : lamps_(all.size()), most_(most) {
    if (lamps_ <= most_) return;
    balls_.reserve(lamps_);
    float brightest = 0;
    all.for_each([&](const Luminaire& luminaire) {
        const LightBounds b = bounds(luminaire);
        balls_.push_back({{single(b.centre.x), single(b.centre.y), single(b.centre.z)},
                          single(b.radius),
                          single(b.luminance)});
        brightest = std::max(brightest, balls_.back().luminance);
    });
    if (!(brightest > 0)) return;
    for (Ball& ball : balls_) ball.luminance /= brightest;
}

LampDraw::Chances LampDraw::chances(const Sight& sight) const {
    Chances result;
    result.lamps_ = lamps_;
    if (balls_.empty()) return result;
    struct Share {
        float size, light;
    };
    std::vector<Share> shares(lamps_);
    double sizes = 0, lights = 0;
    for (std::size_t i = 0; i < lamps_; ++i) {
        const Ball& ball = balls_[i];
        const Vec3 away = Vec3(ball.centre[0], ball.centre[1], ball.centre[2]) - sight.from;
        const double radius2 = double{ball.radius} * ball.radius;
        const double distance2 = dot(away, away) + radius2;
        // The solid angle, up to a factor. A lamp that is wide may lie ahead with a part of it.
        const double size = std::fmax(radius2 / std::fmax(distance2, 1e-300), 1e-30);
        const double cosine = dot(away, sight.ahead) / std::sqrt(std::fmax(distance2, 1e-300));
        const double ahead = std::clamp(cosine + size, 0.0, 1.0);
        const double bright = sight.squares ? ball.luminance * ball.luminance : ball.luminance;
        shares[i] = {single(size), single(size * bright * std::fmax(ahead * ahead, aside))};
        sizes += shares[i].size;
        lights += shares[i].light;
    }
    const double most = static_cast<double>(most_);
    const double per_size = (lights > 0 ? by_size : 1) * most / sizes;
    const double per_light = lights > 0 ? (1 - by_size) * most / lights : 0;
    result.reached_.reserve(lamps_);
    double reached = 0;
    for (const Share& share : shares) {
        reached += std::fmin(per_size * share.size + per_light * share.light, 1);
        result.reached_.push_back(reached);
    }
    return result;
}

void LampDraw::Chances::draw(double u, FunctionRef<void(LightIndex, double)> use) const {
    if (reached_.empty()) {
        for (LightIndex lamp = 0; lamp < lamps_; ++lamp) use(lamp, 1);
        return;
    }
    auto at = reached_.begin();
    for (double next = u;; next += 1) {
        at = std::upper_bound(at, reached_.end(), next);
        if (at == reached_.end()) return;
        const double chance = *at - (at == reached_.begin() ? 0 : *(at - 1));
        use(static_cast<LightIndex>(at - reached_.begin()), 1 / chance);
        ++at;
    }
}

}  // namespace candelabra
