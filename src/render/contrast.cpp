// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/contrast.h"

#include "base/gamma.h"
#include "base/parallel.h"

Vec3 Contrast::shown(const Vec3& colour) const {
    Vec3 compared;
    for (int i = 0; i < 3; ++i)
        compared[i] = from_linear(to_linear(colour[i], assumed_gamma), gamma);
    return compared;
}

Contrast contrast_of(const RenderSettings& settings, double assumed_gamma) {
    return {settings.antialias_threshold, assumed_gamma, settings.antialias_gamma};
}

ContrastRule contrast_rule(const RenderSettings& settings, double assumed_gamma) {
    return {contrast_of(settings, assumed_gamma), settings.antialias_depth,
            settings.jitter ? settings.jitter_amount : 0};
}

std::uint32_t all_samples(const ContrastRule& rule) {
    return static_cast<std::uint32_t>(1 + rule.across * rule.across);
}

std::vector<bool> standing_out(const Film& film, const ContrastRule& rule, int threads) {
    const int width = film.width(), height = film.height();
    Image shown(width, height);
    run_parallel(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) shown.at(x, y) = rule.contrast.shown(film.at(x, y).mean());
    });
    std::vector<bool> found(shown.pixels.size());
    const auto compare = [&](int x, int y, int u, int v) {
        const Vec3 difference = glm::abs(shown.at(x, y) - shown.at(u, v));
        if (difference.x + difference.y + difference.z >= rule.contrast.threshold)
            found[film.index(x, y)] = found[film.index(u, v)] = true;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (x > 0) compare(x, y, x - 1, y);
            if (y > 0) compare(x, y, x, y - 1);
        }
    return found;
}

Vec2 place_in_pixel(const ContrastRule& rule, const Key& key) {
    if (key.sample == 0) return Vec2(0.5);
    const int cell = static_cast<int>(key.sample) - 1;
    const auto moved = [&](Purpose purpose) {
        return rule.jitter == 0 ? 0 : rule.jitter * (uniform(key, purpose) - 0.5);
    };
    return Vec2(cell % rule.across + 0.5 + moved(Purpose::pixel_x),
                cell / rule.across + 0.5 + moved(Purpose::pixel_y)) /
           static_cast<double>(rule.across);
}
