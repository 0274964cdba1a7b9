// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/relighting.h"

#include "base/parallel.h"
#include "base/target_clones.h"
#include "relight/factor_means.h"
#include "relight/half.h"

#include <algorithm>

namespace candelabra {

namespace {

CANDELABRA_TARGET_CLONES
void add_node(const std::uint16_t* light, const Channels& factor, TilePlanes& planes) {
    for (std::size_t c = 0; c < 3; ++c, light += tile_pixels) {
        const float by = factor[c];
        if (by == 0) continue;
        float* const to = planes.data() + c * tile_pixels;
        for (std::size_t i = 0; i < tile_pixels; ++i) to[i] += by * from_half(light[i]);
    }
}

void add_entry(const LampEntry& entry, const Channels& factor, TilePlanes& planes) {
    for (std::size_t c = 0; c < 3; ++c)
        planes[c * tile_pixels + entry.pixel] += factor[c] * entry.light[c];
}

/// Puts a tile into a picture.
void put_tile(const TilePlanes& tile, std::size_t number, const LightRecords& records,
              Image& image) {
    const auto across = static_cast<std::size_t>(records.tiles_across());
    const int left = static_cast<int>(number % across) * light_tile,
              top = static_cast<int>(number / across) * light_tile;
    const int columns = std::min(light_tile, records.width - left),
              rows = std::min(light_tile, records.height - top);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto pixel = static_cast<std::size_t>(y * light_tile + x);
            image.at(left + x, top + y) = {static_cast<double>(tile[pixel]),
                                           static_cast<double>(tile[tile_pixels + pixel]),
                                           static_cast<double>(tile[2 * tile_pixels + pixel])};
        }
}

}  // namespace

Relighting::Relighting(const LightRecords& records, int smooth, int threads)
    : records_(records), threads_(threads), node_of_(records.tiles.size()) {
    if (smooth > 0) crowds_.emplace(records, smooth, threads);
    run_parallel(records.tiles.size(), threads, [&](std::size_t number) {
        const TileRecords& tile = records.tiles[number];
        if (is_smooth(tile)) return;
        node_of_[number].reserve(tile.residual.size());
        for (const LampEntry& entry : tile.residual) {
            const auto after =
                std::ranges::upper_bound(tile.nodes, entry.lamp, {}, &LampRange::first);
            node_of_[number].push_back(static_cast<std::uint32_t>(after - tile.nodes.begin()) - 1);
        }
    });
}

/// Adds the light of a tile; without that of crowds, if this is smooth.
void Relighting::add_light(std::size_t number, const FactorMeans& means,
                           std::span<const Channels> factors, TilePlanes& planes) const {
    const TileRecords& tile = records_.tiles[number];
    std::vector<Channels> mean_of_node;
    for (std::size_t n = 0; n < tile.nodes.size(); ++n) {
        if (is_smooth(tile) && tile.nodes[n].size() > 1) continue;
        const Rgb mean = means(tile.nodes[n]);
        mean_of_node.push_back(channels(mean));
        add_node(tile.light.data() + n * 3 * tile_pixels,
                 channels(mean * static_cast<double>(tile.scale)), planes);
    }
    for (const LampEntry& entry : tile.own) add_entry(entry, factors[entry.lamp], planes);
    if (is_smooth(tile)) return;
    for (std::size_t i = 0; i < tile.residual.size(); ++i) {
        const LampEntry& entry = tile.residual[i];
        const Channels& mean = mean_of_node[node_of_[number][i]];
        Channels off = factors[entry.lamp];
        for (std::size_t c = 0; c < 3; ++c) off[c] -= mean[c];
        add_entry(entry, off, planes);
    }
}

Image Relighting::picture(std::span<const Rgb> factors) const {
    const FactorMeans means(records_.lamps, factors);
    std::vector<Channels> short_factors;
    short_factors.reserve(factors.size());
    for (const Rgb& factor : factors) short_factors.push_back(channels(factor));
    SmoothCrowds::Fit fit;
    if (crowds_) fit = crowds_->fitted(means, short_factors);
    Image image(records_.width, records_.height);
    run_parallel(records_.tiles.size(), threads_, [&](std::size_t number) {
        TilePlanes planes{};
        if (records_.tiles[number].rest) planes = *records_.tiles[number].rest;
        add_light(number, means, short_factors, planes);
        if (crowds_) crowds_->add(fit, number, planes);
        put_tile(planes, number, records_, image);
    });
    return image;
}

Image relit(const LightRecords& records, std::span<const Rgb> factors, int threads) {
    return Relighting(records, 0, threads).picture(factors);
}

}  // namespace candelabra
