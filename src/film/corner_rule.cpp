// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/corner_rule.h"

#include <algorithm>
#include <array>
#include <utility>

namespace candelabra {

namespace {

using FourSights = std::array<const PixelSample*, 4>;

PixelSample mean_of(const FourSights& sights) {
    PixelSample mean = *sights[0];
    for (std::size_t i = 1; i < sights.size(); ++i) {
        mean.colour += sights[i]->colour;
        for (std::size_t j = 0; j < mean.extra.size(); ++j) mean.extra[j] += sights[i]->extra[j];
    }
    mean.colour /= 4.0;
    for (double& value : mean.extra) value /= 4;
    return mean;
}

}  // namespace

CornerRule corner_rule(const RenderSettings& settings, double assumed_gamma, double exposure) {
    return {contrast_of(settings, assumed_gamma, exposure), settings.antialias_depth,
            settings.jitter ? settings.jitter_amount : 0};
}

std::optional<CornerRule> CornerRule::chosen(const RuleChoice& choice) {
    if (!choice.compares_rays() || choice.settings.sampling_method <= 1) return {};
    return corner_rule(choice.settings, choice.assumed_gamma, choice.film.exposure_factor());
}

std::optional<Vec2> CornerRule::place(const Key& key) const {
    const std::uint32_t across = quarters_across();
    const std::uint32_t x = key.sample % (across + 1), y = key.sample / (across + 1);
    const Vec2 place = Vec2(x, y) / static_cast<double>(across);
    if (jitter == 0 || (x % across == 0 && y % across == 0)) return place;
    // POV-Ray's least distance is slightly smaller than that of the samples.
    const double least = 1.0 / (2 * across + 1);
    return place +
           jitter * least *
               Vec2(uniform(key, Purpose::pixel_x) - 0.5, uniform(key, Purpose::pixel_y) - 0.5);
}

std::uint64_t CornerRule::make(TileSamples& tile, std::uint32_t level) const {
    CornerCells cells(*this, tile.region());
    const auto look = [&](int x, int y, std::uint32_t sample) { return tile.look(x, y, sample); };
    std::uint64_t made = 0;
    for_pixels(tile.film(), tile.region(), [&](int x, int y, const PixelSum& pixel) {
        if (pixel.samples >= std::min(level, pixel.planned) || tile.stopped()) return;
        tile.add(x, y, cells.pixel(x, y, look));
        ++made;
    });
    return made;
}

CornerCells::CornerCells(const CornerRule& rule, const Region& tile)
    : rule_(rule),
      tile_(tile),
      corners_(
          static_cast<std::size_t>((tile.right - tile.left + 1) * (tile.bottom - tile.top + 1))) {}

PixelSample CornerCells::pixel(int x, int y, Look look) {
    inside_.clear();
    const Pixel pixel{x, y, look};
    PixelSample sight = mean(pixel, {0, 0, rule_.quarters_across()});
    sight.shadow_rays = point(pixel, 0, 0).sight.shadow_rays;
    for (const auto& [sample, point] : inside_) sight.shadow_rays += point.sight.shadow_rays;
    return sight;
}

const CornerCells::Point& CornerCells::point(const Pixel& pixel, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t across = rule_.quarters_across();
    if (x % across == 0 && y % across == 0) {
        const Pixel owner{pixel.x + static_cast<int>(x / across),
                          pixel.y + static_cast<int>(y / across), pixel.look};
        const int row = owner.y - tile_.top, column = owner.x - tile_.left;
        std::optional<Point>& corner =
            corners_[static_cast<std::size_t>(row * (tile_.right - tile_.left + 1) + column)];
        if (!corner) corner = seen(owner, 0);
        return *corner;
    }
    const std::uint32_t sample = y * (across + 1) + x;
    const auto found = inside_.find(sample);
    return found != inside_.end() ? found->second
                                  : inside_.emplace(sample, seen(pixel, sample)).first->second;
}

CornerCells::Point CornerCells::seen(const Pixel& pixel, std::uint32_t sample) const {
    PixelSample sight = pixel.look(pixel.x, pixel.y, sample);
    const DisplayValue shown = rule_.contrast.shown(sight.colour, sight.clear);
    return {std::move(sight), shown};
}

PixelSample CornerCells::mean(const Pixel& pixel, const Cell& cell) {
    const std::array<const Point*, 4> corners = {
        &point(pixel, cell.x, cell.y), &point(pixel, cell.x + cell.size, cell.y),
        &point(pixel, cell.x, cell.y + cell.size),
        &point(pixel, cell.x + cell.size, cell.y + cell.size)};
    bool even = true;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            even = even && !rule_.contrast.between(corners[i]->shown, corners[j]->shown);
    if (even || cell.size == 1)
        return mean_of(
            {&corners[0]->sight, &corners[1]->sight, &corners[2]->sight, &corners[3]->sight});
    const std::uint32_t half = cell.size / 2;
    const PixelSample a = mean(pixel, {cell.x, cell.y, half}),
                      b = mean(pixel, {cell.x + half, cell.y, half}),
                      c = mean(pixel, {cell.x, cell.y + half, half}),
                      d = mean(pixel, {cell.x + half, cell.y + half, half});
    return mean_of({&a, &b, &c, &d});
}

}  // namespace candelabra
