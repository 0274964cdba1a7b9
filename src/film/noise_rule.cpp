// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/noise_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candelabra {

namespace {

/// Maximum number of samples per pixel to reduce noise, unless --samples allows more.
constexpr std::uint32_t max_for_noise = 1 << 16;

}  // namespace

std::uint32_t samples_to_add(const Film& film, int x, int y, const NoiseBound& bound) {
    double deviation = 0;
    for (int v = std::max(0, y - 1); v <= std::min(film.height() - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(film.width() - 1, x + 1); ++u)
            if ((u != x || v != y) && film.at(u, v).samples > 1)
                deviation = std::max(deviation, film.at(u, v).deviation());
    const double ratio = deviation / bound.error;
    const double needed = ratio * ratio;
    const std::uint32_t has = film.at(x, y).samples;
    const double total = std::min(std::ceil(needed), static_cast<double>(bound.at_most));
    return total > has ? static_cast<std::uint32_t>(total) - has : 0;
}

std::optional<NoiseRule> NoiseRule::chosen(const RuleChoice& choice) {
    const RenderSettings& settings = choice.settings;
    if (choice.is_requested() || !settings.antialias || !choice.random || !choice.quiet)
        return NoiseRule();
    // The maximum number that a pixel gets for its contrast.
    const auto depth = static_cast<std::uint32_t>(settings.antialias_depth);
    return NoiseRule{depth * depth + 1};
}

DecidedBy NoiseRule::decided_by(const RenderSettings& settings) {
    const bool even = settings.noise == 0 && (settings.samples > 0 || !settings.antialias);
    return even ? DecidedBy::settings : DecidedBy::neighbours;
}

int NoiseRule::first(const FirstSamples& wanted) const {
    constexpr int first_of_quiet = 4;
    const int usual = at_most > 0 ? std::min(wanted.usual, first_of_quiet) : wanted.usual;
    return std::max(usual, wanted.least);
}

std::uint32_t NoiseRule::most(const RenderSettings& settings, std::uint32_t first) const {
    if (decided_by(settings) == DecidedBy::settings) return first;
    return std::max(first, bound(settings).at_most);
}

NoiseBound NoiseRule::bound(const RenderSettings& settings) const {
    if (settings.noise > 0)
        return {settings.noise, settings.samples > 0 ? static_cast<std::uint32_t>(settings.samples)
                                                     : max_for_noise};
    // POV-Ray's threshold applies to the difference of two rays; the mean of many should be more
    // accurate. `most`: maximum number of rays per pixel of its recursive method.
    const std::uint32_t most = std::uint32_t{1} << (2 * settings.antialias_depth);
    return {settings.antialias_threshold / 10, at_most > 0 ? std::min(most, at_most) : most};
}

void NoiseRule::refine(RenderState& state, const RenderSettings& settings) const {
    if (settings.noise == 0 && state.rounds > 1) return;
    const NoiseBound enough = bound(settings);
    std::vector<std::uint32_t> more(state.film.pixels().size());
    for_pixels(state.film, [&](int x, int y, const PixelSum& pixel) {
        if (!state.shard.owns(x, y)) return;
        std::uint32_t& add = more[state.film.index(x, y)];
        add = samples_to_add(state.film, x, y, enough);
        // A first estimate of the noise may be far off, so the number of samples at most doubles.
        if (settings.noise > 0) add = std::min(add, pixel.samples);
    });
    for_pixels(state.film, [&](int x, int y, PixelSum& pixel) {
        pixel.planned = pixel.samples + more[state.film.index(x, y)];
    });
}

}  // namespace candelabra
