// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/relighting.h"

#include "base/parallel.h"
#include "relight/factor_means.h"
#include "relight/half.h"
#include "relight/plane_blur.h"

#include <algorithm>

namespace candelabra {

namespace {

/// One tile under some factors: light that is exact for each lamp, and that of crowds.
class RelitTile {
public:
    RelitTile(const TileRecords& tile, const FactorMeans& means, std::span<const Vec3> factors) {
        if (tile.rest) sharp_ = *tile.rest;
        std::vector<Vec3> mean_of_node;
        for (std::size_t i = 0; i < tile.nodes.size(); ++i) {
            mean_of_node.push_back(means(tile.nodes[i]));
            add_node(tile.light.data() + i * 3 * tile_pixels,
                     mean_of_node.back() * static_cast<double>(tile.scale),
                     tile.nodes[i].size() > 1 ? crowd_ : sharp_);
        }
        for (const LampEntry& entry : tile.own) add(entry, factors[entry.lamp], sharp_);
        for (const LampEntry& entry : tile.residual) {
            const auto after =
                std::ranges::upper_bound(tile.nodes, entry.lamp, {}, &LampRange::first);
            const auto node = static_cast<std::size_t>(after - tile.nodes.begin()) - 1;
            add(entry, factors[entry.lamp] - mean_of_node[node], crowd_);
        }
    }

    const TilePlanes& sharp() const { return sharp_; }
    const TilePlanes& crowd() const { return crowd_; }

private:
    static void add_node(const std::uint16_t* light, const Vec3& factor, TilePlanes& planes) {
        for (int c = 0; c < 3; ++c, light += tile_pixels) {
            const auto by = static_cast<float>(factor[c]);
            if (by == 0) continue;
            float* const to = planes.data() + static_cast<std::size_t>(c) * tile_pixels;
            for (std::size_t i = 0; i < tile_pixels; ++i) to[i] += by * from_half(light[i]);
        }
    }

    static void add(const LampEntry& entry, const Vec3& factor, TilePlanes& planes) {
        for (std::size_t c = 0; c < 3; ++c)
            planes[c * tile_pixels + entry.pixel] +=
                static_cast<float>(factor[static_cast<int>(c)]) * entry.light[c];
    }

    TilePlanes sharp_{}, crowd_{};
};

/// Adds a tile's planes to those of a picture.
void add_tile(const TilePlanes& tile, std::size_t number, const LightRecords& records,
              PicturePlanes& planes) {
    const auto across = static_cast<std::size_t>(records.tiles_across());
    const auto left = static_cast<int>(number % across) * light_tile,
               top = static_cast<int>(number / across) * light_tile;
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const std::size_t pixel = i % tile_pixels;
        const int x = left + static_cast<int>(pixel) % light_tile,
                  y = top + static_cast<int>(pixel) / light_tile;
        if (x < records.width && y < records.height)
            planes[i / tile_pixels]
                  [static_cast<std::size_t>(y) * static_cast<std::size_t>(records.width) +
                   static_cast<std::size_t>(x)] += tile[i];
    }
}

}  // namespace

Relighting::Relighting(const LightRecords& records, int smooth, int threads)
    : records_(records), smooth_(smooth), threads_(threads) {
    if (smooth_ == 0) return;
    const std::vector<Vec3> usual(records.lamps.size(), Vec3(1));
    crowd_ = planes_of(usual).crowd;
    blurred_ = crowd_;
    for (std::vector<float>& plane : blurred_)
        blur(plane, records.width, records.height, smooth_, threads_);
}

Relighting::Split Relighting::planes_of(std::span<const Vec3> factors) const {
    const FactorMeans means(records_.lamps, factors);
    const auto pixels =
        static_cast<std::size_t>(records_.width) * static_cast<std::size_t>(records_.height);
    Split made;
    for (PicturePlanes* planes : {&made.sharp, &made.crowd})
        for (std::vector<float>& plane : *planes) plane.assign(pixels, 0);
    run_parallel(records_.tiles.size(), threads_, [&](std::size_t number) {
        const RelitTile tile(records_.tiles[number], means, factors);
        add_tile(tile.sharp(), number, records_, made.sharp);
        add_tile(tile.crowd(), number, records_, smooth_ == 0 ? made.sharp : made.crowd);
    });
    return made;
}

Image Relighting::picture(std::span<const Vec3> factors) const {
    const Split made = planes_of(factors);
    Image image(records_.width, records_.height);
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i][channel] = static_cast<double>(made.sharp[c][i]);
        if (smooth_ == 0) continue;
        std::vector<float> blurred = made.crowd[c];
        blur(blurred, records_.width, records_.height, smooth_, threads_);
        // What the crowds give, in terms of what they gave: this changes more slowly than either.
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const double usual = static_cast<double>(blurred_[c][i]);
            if (usual > 0)
                image.pixels[i][channel] += static_cast<double>(crowd_[c][i]) *
                                            std::max(static_cast<double>(blurred[i]), 0.0) / usual;
            else
                image.pixels[i][channel] += static_cast<double>(made.crowd[c][i]);
        }
    }
    return image;
}

Image relit(const LightRecords& records, std::span<const Vec3> factors, int threads) {
    return Relighting(records, 0, threads).picture(factors);
}

}  // namespace candelabra
