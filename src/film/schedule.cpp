// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/schedule.h"

#include "film/adaptive.h"

namespace candelabra {

namespace {

/// Maximum number of samples per pixel to reduce noise, unless --samples allows more.
constexpr std::uint32_t max_for_noise = 1 << 16;

/// Whether the pixel or one of its neighbours belongs to the shard.
bool borders(const PictureShard& shard, int x, int y) {
    for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
            if (shard.owns(u, v)) return true;
    return false;
}

/// Calls set(x, y, pixel) for all pixels.
template <class Set>
void for_pixels(Film& film, const Set& set) {
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) set(x, y, film.at(x, y));
}

AdaptiveRule rule_of(const RenderSettings& settings, const NoiseRule& rule) {
    if (settings.noise > 0)
        return {settings.noise, settings.samples > 0 ? static_cast<std::uint32_t>(settings.samples)
                                                     : max_for_noise};
    // POV-Ray's threshold applies to the difference of two rays; the mean of many should be more
    // accurate. `most`: maximum number of rays per pixel of its recursive method.
    const std::uint32_t most = std::uint32_t{1} << (2 * settings.antialias_depth);
    return {settings.antialias_threshold / 10,
            rule.at_most > 0 ? std::min(most, rule.at_most) : most};
}

void refine(RenderState& state, const RenderSettings& settings, const NoiseRule& noise) {
    if (settings.noise == 0 && state.rounds > 1) return;
    const AdaptiveRule rule = rule_of(settings, noise);
    std::vector<std::uint32_t> more(state.film.pixels().size());
    for_pixels(state.film, [&](int x, int y, const PixelSum& pixel) {
        if (!state.shard.owns(x, y)) return;
        std::uint32_t& add = more[state.film.index(x, y)];
        add = samples_to_add(state.film, x, y, rule);
        // A first estimate of the noise may be far off, so the number of samples at most doubles.
        if (settings.noise > 0) add = std::min(add, pixel.samples);
    });
    for (std::size_t i = 0; i < more.size(); ++i)
        state.film.pixels()[i].target = state.film.pixels()[i].samples + more[i];
}

/// Refines each pixel by its own samples, as POV-Ray does, but not after each sample.
void refine(RenderState& state, const RenderSettings&, const BlurRule& rule) {
    const auto most = static_cast<std::uint32_t>(rule.most);
    for_pixels(state.film, [&](int x, int y, PixelSum& pixel) {
        const std::uint32_t n = pixel.samples;
        if (state.shard.owns(x, y) && pixel.variance_of_mean() > rule.allowed(static_cast<int>(n)))
            pixel.target = std::min(most, n + n / 4 + 1);
    });
}

/// Tiles have taken all samples already.
void refine(RenderState&, const RenderSettings&, const ContrastRule&) {}
void refine(RenderState&, const RenderSettings&, const CornerRule&) {}

/// Whether pixels are judged by their neighbours, which a shard must then sample, too.
bool looks_around(const RenderSettings& settings, const SampleRule& rule) {
    return !is_even(settings, rule) && !std::holds_alternative<BlurRule>(rule) &&
           !is_settled_by_tiles(rule);
}

}  // namespace

RenderState begin_picture(const RenderSettings& settings, std::size_t aovs) {
    return {Film(settings.width, settings.height, aovs),
            whole_picture(settings.width, settings.height), 0};
}

bool is_settled_by_tiles(const SampleRule& rule) {
    return std::holds_alternative<ContrastRule>(rule) || std::holds_alternative<CornerRule>(rule);
}

bool is_even(const RenderSettings& settings, const SampleRule& rule) {
    return settings.noise == 0 && (settings.samples > 0 || !settings.antialias) &&
           !std::holds_alternative<BlurRule>(rule);
}

bool plan_round(RenderState& state, const RenderSettings& settings, std::uint32_t samples,
                const SampleRule& rule) {
    Wanted all;
    if (is_even(settings, rule) || state.rounds == 0) {
        const bool around = looks_around(settings, rule);
        for_pixels(state.film, [&](int x, int y, PixelSum& pixel) {
            const bool wanted = around ? borders(state.shard, x, y) : state.shard.owns(x, y);
            pixel.target = wanted ? samples : 0;
            all.add(pixel);
        });
    } else {
        std::visit([&](const auto& each) { refine(state, settings, each); }, rule);
        all = wanted_samples(state.film);
    }
    if (all.missing == 0) return false;
    ++state.rounds;
    return true;
}

std::uint32_t max_wanted(const RenderSettings& settings, std::uint32_t samples,
                         const SampleRule& rule) {
    if (is_even(settings, rule) || is_settled_by_tiles(rule)) return samples;
    if (const auto* const blur = std::get_if<BlurRule>(&rule))
        return std::max(samples, static_cast<std::uint32_t>(blur->most));
    return std::max(samples, rule_of(settings, std::get<NoiseRule>(rule)).at_most);
}

Wanted wanted_samples(const Film& film) {
    Wanted all;
    for (const PixelSum& pixel : film.pixels()) all.add(pixel);
    return all;
}

}  // namespace candelabra
