// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/light_recorder.h"

#include "base/parallel.h"
#include "base/random.h"
#include "relight/byte_stream.h"
#include "relight/record_blocks.h"

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
      tiles_(static_cast<std::size_t>(tiles_of(plan))),
      lit_(lamps_.list.size()) {
    made_.width = plan.width;
    made_.height = plan.height;
    made_.lamps = std::move(lamps_.list);
}

std::uint64_t LightRecorder::seed_of(std::size_t tile) const { return mix(tile + 1); }

void LightRecorder::add(int x, int y, std::span<const LampPart> parts, bool negative) {
    // Rules that compare pixels look beyond the picture; they do not add what they see.
    if (x < 0 || y < 0 || x >= made_.width || y >= made_.height) return;
    const int column = x / light_tile, row = y / light_tile;
    const auto number = static_cast<std::size_t>(row * made_.tiles_across() + column);
    const auto pixel = static_cast<std::size_t>(y % light_tile * light_tile + x % light_tile);
    TileLight& tile = tiles_[number];
    for (const LampPart& part : parts) {
        const std::uint32_t lamp = lamps_.place_of(part.lamp);
        tile.add(lamp, pixel, negative ? -part.light : part.light, part.seen);
        if (part.light != Rgb(0)) lit_[lamp].store(true, std::memory_order_relaxed);
    }
    if (tile.crowded()) tile.settle(made_.lamps, room_, seed_of(number));
}

void LightRecorder::passed(const Region& region) {
    for (int y = region.top; y < region.bottom; y += light_tile)
        for (int x = region.left; x < region.right; x += light_tile) {
            const auto number =
                static_cast<std::size_t>(y / light_tile * made_.tiles_across() + x / light_tile);
            tiles_[number].settle(made_.lamps, room_, seed_of(number));
        }
}

std::uint64_t LightRecorder::most_memory() const {
    // Light has twice the bytes that it has in the file, which is made beside it, and tiles in work
    // have it as it comes.
    constexpr std::uint64_t in_memory = 3, in_work = std::uint64_t{64} << 20;
    return in_memory * room_ * tiles_.size() + made_.normals.size() + lit_.size() + in_work;
}

LightRecords LightRecorder::finish(const Film& film, int threads) const {
    LightRecords made = made_;
    made.tiles.resize(tiles_.size());
    run_parallel(tiles_.size(), threads, [&](std::size_t number) {
        const int across = made.tiles_across();
        const int left = static_cast<int>(number) % across * light_tile,
                  top = static_cast<int>(number) / across * light_tile;
        TilePixels pixels;
        for (std::size_t i = 0; i < tile_pixels; ++i) {
            const int x = left + static_cast<int>(i) % light_tile,
                      y = top + static_cast<int>(i) / light_tile;
            if (x >= made.width || y >= made.height) continue;
            pixels.weight[i] = film.at(x, y).weight();
            pixels.mean[i] = film.at(x, y).mean();
        }
        TileLight tile = tiles_[number];
        made.tiles[number] = tile.finished(made.lamps, pixels, room_, seed_of(number));
    });
    return made;
}

std::string LightRecorder::state(int threads) const {
    const auto across = static_cast<std::size_t>(made_.tiles_across());
    std::vector<std::string> blocks(static_cast<std::size_t>(made_.tiles_down()));
    run_parallel(blocks.size(), threads, [&](std::size_t row) {
        std::string raw;
        for (std::size_t i = 0; i < across; ++i) tiles_[row * across + i].append_to(raw);
        blocks[row] = block_of(raw);
    });
    std::string bytes;
    append_number(bytes, static_cast<std::uint64_t>(room_));
    std::string lit;
    for (const bool each : lit_) lit += each ? '\1' : '\0';
    bytes += block_of(head_of(made_)) + block_of(lit) + block_of(meters_of(made_.meters)) +
             block_of(normals_of(made_.normals));
    for (const std::string& block : blocks) bytes += block;
    return bytes;
}

std::unique_ptr<LightRecorder> LightRecorder::of_state(std::string_view bytes) {
    ByteReader reader(bytes);
    std::unique_ptr<LightRecorder> read(new LightRecorder);
    LightRecords& made = read->made_;
    read->room_ = static_cast<std::size_t>(reader.number<std::uint64_t>());
    std::uint64_t left = most_unpacked(bytes.size());
    const auto head = take_block(reader, left), lit = take_block(reader, left),
               meters = take_block(reader, left), normals = take_block(reader, left);
    if (!head || !take_head(*head, made) || !lit || lit->size() != made.lamps.size() || !meters ||
        !take_meters(*meters, made.lamps.size(), made.meters) || !normals ||
        !take_normals(*normals, made))
        return nullptr;
    read->lit_ = std::vector<std::atomic<bool>>(lit->size());
    for (std::size_t lamp = 0; lamp < lit->size(); ++lamp) read->lit_[lamp] = (*lit)[lamp] != 0;
    for (int row = 0; row < made.tiles_down(); ++row) {
        const auto raw = take_block(reader, left);
        if (!raw) return nullptr;
        std::string_view rest = *raw;
        for (int column = 0; column < made.tiles_across(); ++column) {
            auto tile = TileLight::take(rest, made.lamps.size());
            if (!tile) return nullptr;
            read->tiles_.push_back(std::move(*tile));
        }
        if (!rest.empty()) return nullptr;
    }
    return reader.left().empty() ? std::move(read) : nullptr;
}

/// Whether it keeps the light of the same lamps in a picture of the same size, in as many bytes.
bool LightRecorder::is_like(const LightRecorder& other) const {
    return made_.width == other.made_.width && made_.height == other.made_.height &&
           made_.lamps == other.made_.lamps && room_ == other.room_;
}

bool LightRecorder::go_on(std::string_view state) {
    const auto old = of_state(state);
    if (!old || !is_like(*old)) return false;
    tiles_ = std::move(old->tiles_);
    lit_ = std::move(old->lit_);
    return true;
}

bool LightRecorder::adopt(LightRecorder&& part, const PictureShard& shard) {
    if (!is_like(part)) return false;
    const auto across = static_cast<std::size_t>(made_.tiles_across());
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        if (shard.owns(static_cast<int>(i % across) * light_tile,
                       static_cast<int>(i / across) * light_tile))
            tiles_[i] = std::move(part.tiles_[i]);
    for (std::size_t lamp = 0; lamp < lit_.size(); ++lamp)
        if (part.lit_[lamp]) lit_[lamp] = true;
    if (made_.meters.meters.empty()) made_.meters = std::move(part.made_.meters);
    return true;
}

}  // namespace candelabra
