// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_recorder.h"

#include "base/parallel.h"
#include "base/random.h"

#include <algorithm>
#include <utility>

namespace candelabra {

namespace {

constexpr std::uint64_t least_tile_bytes = 1024;

std::uint64_t tiles_of(const RecordPlan& plan) {
    const auto along = [](int size) {
        return static_cast<std::uint64_t>((size + light_tile - 1) / light_tile);
    };
    return along(plan.width) * along(plan.height);
}

std::uint64_t bytes_of(const LampList& lamps) {
    constexpr std::uint64_t for_name = 16;
    std::uint64_t bytes = lamps.size() * (sizeof(std::uint32_t) + sizeof(float));
    for (const LampGroup& group : lamps.groups()) bytes += group.name.size() + for_name;
    return bytes;
}

}  // namespace

std::uint64_t usual_record_bytes(int width, int height) {
    constexpr std::uint64_t for_pixel = 150, least = std::uint64_t{16} << 20;
    return std::max(
        least, for_pixel * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height));
}

std::uint64_t least_record_bytes(const RecordPlan& plan, const LampList& lamps) {
    return plan.before + bytes_of(lamps) + tiles_of(plan) * (least_tile_bytes + tile_head_bytes);
}

LightRecorder::LightRecorder(WorldLamps lamps, const RecordPlan& plan)
    : lamps_(std::move(lamps)),
      room_(static_cast<std::size_t>((plan.bytes - plan.before - bytes_of(lamps_.list)) /
                                     tiles_of(plan)) -
            tile_head_bytes),
      tiles_(static_cast<std::size_t>(tiles_of(plan))) {
    made_.width = plan.width;
    made_.height = plan.height;
}

std::uint64_t LightRecorder::seed_of(std::size_t tile) const { return mix(tile + 1); }

void LightRecorder::add(int x, int y, std::span<const LampPart> parts, bool negative) {
    // Rules that compare pixels look beyond the picture; they do not add what they see.
    if (x < 0 || y < 0 || x >= made_.width || y >= made_.height) return;
    const int column = x / light_tile, row = y / light_tile;
    const auto number = static_cast<std::size_t>(row * made_.tiles_across() + column);
    const auto pixel = static_cast<std::size_t>(y % light_tile * light_tile + x % light_tile);
    TileLight& tile = tiles_[number];
    for (const LampPart& part : parts)
        tile.add(lamps_.place_of(part.lamp), pixel, negative ? -part.light : part.light, part.seen);
    if (tile.crowded()) tile.settle(lamps_.list, room_, seed_of(number));
}

void LightRecorder::passed(const Region& region) {
    for (int y = region.top; y < region.bottom; y += light_tile)
        for (int x = region.left; x < region.right; x += light_tile) {
            const auto number =
                static_cast<std::size_t>(y / light_tile * made_.tiles_across() + x / light_tile);
            tiles_[number].settle(lamps_.list, room_, seed_of(number));
        }
}

std::uint64_t LightRecorder::most_memory() const {
    // Light has twice the bytes that it has in the file, and tiles in work have it as it comes.
    constexpr std::uint64_t in_memory = 2, in_work = std::uint64_t{64} << 20;
    return in_memory * room_ * tiles_.size() + in_work;
}

LightRecords LightRecorder::finish(const Film& film, int threads) {
    made_.tiles.resize(tiles_.size());
    run_parallel(tiles_.size(), threads, [&](std::size_t number) {
        const int across = made_.tiles_across();
        const int left = static_cast<int>(number) % across * light_tile,
                  top = static_cast<int>(number) / across * light_tile;
        TilePixels pixels;
        for (std::size_t i = 0; i < tile_pixels; ++i) {
            const int x = left + static_cast<int>(i) % light_tile,
                      y = top + static_cast<int>(i) / light_tile;
            if (x >= made_.width || y >= made_.height) continue;
            pixels.weight[i] = film.at(x, y).weight();
            pixels.mean[i] = film.at(x, y).mean();
        }
        made_.tiles[number] = tiles_[number].finished(lamps_.list, pixels, room_, seed_of(number));
    });
    made_.lamps = std::move(lamps_.list);
    return std::move(made_);
}

}  // namespace candelabra
