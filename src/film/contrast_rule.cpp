// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/contrast_rule.h"

#include <utility>
#include <vector>

namespace candelabra {

ContrastRule contrast_rule(const RenderSettings& settings, double assumed_gamma, double exposure) {
    return {contrast_of(settings, assumed_gamma, exposure), settings.antialias_depth,
            settings.jitter ? settings.jitter_amount : 0};
}

std::optional<ContrastRule> ContrastRule::chosen(const RuleChoice& choice) {
    if (!choice.compares_rays() || choice.settings.sampling_method > 1) return {};
    return contrast_rule(choice.settings, choice.assumed_gamma, choice.film.exposure_factor());
}

bool refine_block(const Contrast& contrast, const Region& block, const ContrastPixels& pixels) {
    const int left = block.left - 1, top = block.top - 1, across = block.right - left;
    std::vector<DisplayValue> shown;
    for (int y = top; y < block.bottom; ++y)
        for (int x = left; x < block.right; ++x)
            // The upper left corner is adjacent to no pixel of the block.
            shown.push_back(x == left && y == top ? DisplayValue() : pixels.first(x, y));
    std::vector<bool> refined(shown.size());
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>((y - top) * across + (x - left));
    };
    const auto refine = [&](int x, int y) {
        if (!block.contains(x, y) || refined[at(x, y)]) return true;
        const std::optional<DisplayValue> all = pixels.all(x, y);
        if (all) shown[at(x, y)] = *all;
        refined[at(x, y)] = true;
        return all.has_value();
    };
    for (int y = block.top; y < block.bottom; ++y)
        for (int x = block.left; x < block.right; ++x) {
            const DisplayValue first = shown[at(x, y)];
            for (const auto& [u, v] : {std::pair{x - 1, y}, std::pair{x, y - 1}})
                if (contrast.between(first, shown[at(u, v)]) && !(refine(u, v) && refine(x, y)))
                    return false;
        }
    return true;
}

std::optional<Vec2> ContrastRule::place(const Key& key) const {
    if (key.sample == 0) return Vec2(0.5);
    const int cell = static_cast<int>(key.sample) - 1;
    const auto moved = [&](Purpose purpose) {
        return jitter == 0 ? 0 : jitter * (uniform(key, purpose) - 0.5);
    };
    return Vec2(cell % across + 0.5 + moved(Purpose::pixel_x),
                cell / across + 0.5 + moved(Purpose::pixel_y)) /
           static_cast<double>(across);
}

/// Refines a tile by contrast once its pixels have their first samples. A pixel that already has
/// more than one sample has them from an earlier run. Unwanted pixels of the tile are compared as
/// well, so that the others look as in the whole picture.
std::uint64_t ContrastRule::make(TileSamples& tile, std::uint32_t level) const {
    if (level == 1) return tile.bring_all(level);
    Film& film = tile.film();
    const Region own = tile.own();
    const auto apart = [&](int x, int y, std::uint32_t samples) {
        PixelSum pixel;
        ExactSum clear;
        for (std::uint32_t sample = 0; sample < samples; ++sample) {
            const PixelSample seen = tile.look(x, y, sample);
            pixel.add(seen.colour);
            clear.add(seen.clear);
        }
        return contrast.shown(pixel.mean(), pixel.mean_of(clear.value()));
    };
    const auto shown = [&](int x, int y) {
        return contrast.shown(film.at(x, y).mean(), tile.clear(x, y));
    };
    const auto first = [&](int x, int y) {
        return own.contains(x, y) && film.at(x, y).samples == 1 ? shown(x, y) : apart(x, y, 1);
    };
    const auto all = [&](int x, int y) -> std::optional<DisplayValue> {
        if (!own.contains(x, y)) return apart(x, y, all_samples());
        PixelSum& pixel = film.at(x, y);
        pixel.planned = all_samples();
        tile.bring(x, y, pixel.planned);
        if (pixel.samples < pixel.planned) return {};
        return shown(x, y);
    };
    Wanted before;
    for_pixels(film, own, [&](int, int, const PixelSum& pixel) { before.add(pixel); });
    if (!refine_block(contrast, tile.region(), {first, all})) return 0;
    for_pixels(film, own, [](int, int, PixelSum& pixel) { pixel.planned = pixel.samples; });
    return before.missing;
}

}  // namespace candelabra
