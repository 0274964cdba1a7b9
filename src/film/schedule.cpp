// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/schedule.h"

#include <utility>

namespace candelabra {

namespace {

/// Whether the pixel or one of its neighbours belongs to the shard.
bool borders(const PictureShard& shard, int x, int y) {
    for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
            if (shard.owns(u, v)) return true;
    return false;
}

}  // namespace

RenderState begin_picture(const RenderSettings& settings, std::size_t aovs,
                          std::optional<ZeroedPages> pages) {
    const int width = settings.width, height = settings.height;
    return {pages ? Film(width, height, aovs, std::move(*pages)) : Film(width, height, aovs),
            whole_picture(width, height), 0};
}

bool plan_round(RenderState& state, const RenderSettings& settings, std::uint32_t samples,
                const SampleRule& rule) {
    const DecidedBy by = decided_by(settings, rule);
    if (by == DecidedBy::settings || state.rounds == 0) {
        const bool around = by == DecidedBy::neighbours;
        for_pixels(state.film, [&](int x, int y, PixelSum& pixel) {
            const bool wanted = around ? borders(state.shard, x, y) : state.shard.owns(x, y);
            pixel.planned = wanted ? samples : 0;
        });
    } else {
        std::visit([&](const auto& each) { each.refine(state, settings); }, rule);
    }
    if (wanted_samples(state.film).missing == 0) return false;
    ++state.rounds;
    return true;
}

std::uint32_t max_wanted(const RenderSettings& settings, std::uint32_t samples,
                         const SampleRule& rule) {
    return std::visit([&](const auto& each) { return each.most(settings, samples); }, rule);
}

}  // namespace candelabra
