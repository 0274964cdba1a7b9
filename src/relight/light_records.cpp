// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_records.h"

#include "base/parallel.h"
#include "relight/half.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// Means of the factors over ranges of lamps, by the powers of the lamps.
class FactorMeans {
public:
    FactorMeans(const LampList& lamps, std::span<const Vec3> factors) : sums_(1) {
        sums_.reserve(factors.size() + 1);
        for (std::size_t i = 0; i < factors.size(); ++i) {
            const double power = lamps.powers()[i];
            Sum next = sums_.back();
            next.power += power;
            next.light += power * factors[i];
            sums_.push_back(next);
        }
    }

    Vec3 operator()(const LampRange& range) const {
        const Sum &first = sums_[range.first], &last = sums_[range.last];
        return (last.light - first.light) / (last.power - first.power);
    }

private:
    struct Sum {
        double power = 0;
        Vec3 light = Vec3(0);
    };
    std::vector<Sum> sums_;
};

/// One tile under some factors.
class RelitTile {
public:
    RelitTile(const TileRecords& tile, const FactorMeans& means, std::span<const Vec3> factors) {
        if (tile.rest) light_ = *tile.rest;
        std::vector<Vec3> mean_of_node;
        for (std::size_t i = 0; i < tile.nodes.size(); ++i) {
            mean_of_node.push_back(means(tile.nodes[i]));
            add_node(tile.light.data() + i * 3 * tile_pixels,
                     mean_of_node.back() * static_cast<double>(tile.scale));
        }
        for (const LampEntry& entry : tile.own) add(entry, factors[entry.lamp]);
        for (const LampEntry& entry : tile.residual) {
            const auto after =
                std::ranges::upper_bound(tile.nodes, entry.lamp, {}, &LampRange::first);
            const auto node = static_cast<std::size_t>(after - tile.nodes.begin()) - 1;
            add(entry, factors[entry.lamp] - mean_of_node[node]);
        }
    }

    Vec3 pixel(std::size_t i) const {
        return {light_[i], light_[tile_pixels + i], light_[2 * tile_pixels + i]};
    }

private:
    void add_node(const std::uint16_t* light, const Vec3& factor) {
        for (int c = 0; c < 3; ++c, light += tile_pixels) {
            const auto by = static_cast<float>(factor[c]);
            if (by == 0) continue;
            float* const to = light_.data() + static_cast<std::size_t>(c) * tile_pixels;
            for (std::size_t i = 0; i < tile_pixels; ++i) to[i] += by * from_half(light[i]);
        }
    }

    void add(const LampEntry& entry, const Vec3& factor) {
        for (std::size_t c = 0; c < 3; ++c)
            light_[c * tile_pixels + entry.pixel] +=
                static_cast<float>(factor[static_cast<int>(c)]) * entry.light[c];
    }

    TilePlanes light_{};
};

}  // namespace

Image relit(const LightRecords& records, std::span<const Vec3> factors, int threads) {
    const FactorMeans means(records.lamps, factors);
    Image image(records.width, records.height);
    const auto across = static_cast<std::size_t>(records.tiles_across());
    run_parallel(static_cast<std::size_t>(records.tiles_down()), threads, [&](std::size_t row) {
        for (std::size_t column = 0; column < across; ++column) {
            const RelitTile tile(records.tiles[row * across + column], means, factors);
            const int left = static_cast<int>(column) * light_tile,
                      top = static_cast<int>(row) * light_tile;
            for (std::size_t i = 0; i < tile_pixels; ++i) {
                const int x = left + static_cast<int>(i) % light_tile,
                          y = top + static_cast<int>(i) / light_tile;
                if (x < records.width && y < records.height) image.at(x, y) = tile.pixel(i);
            }
        }
    });
    return image;
}

}  // namespace candelabra
