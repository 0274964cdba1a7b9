// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/tile_records.h"

#include "relight/byte_stream.h"
#include "relight/half.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

/// A power of 2 by which the greatest of all numbers becomes a half well above the small ones.
float scale_for(float greatest) {
    constexpr float usual = 0x1p12F;
    if (!(greatest > 0)) return 1;
    return std::ldexp(1.0F, std::clamp(std::ilogb(greatest / usual), -100, 100));
}

float greatest_in(const std::vector<LampEntry>& entries) {
    float greatest = 0;
    for (const LampEntry& entry : entries) greatest = std::max(greatest, entry.size());
    return greatest;
}

void round_entries(std::vector<LampEntry>& entries) {
    const float scale = scale_for(greatest_in(entries));
    for (LampEntry& entry : entries) {
        for (float& channel : entry.light) channel = from_half(to_half(channel / scale)) * scale;
        entry.seen = false;
    }
    // A lamp may have been seen in a pixel that it lights as well.
    entries = summed(std::move(entries));
    std::erase_if(entries, [](const LampEntry& entry) { return entry.size() == 0; });
}

void append_entries(std::string& bytes, const std::vector<LampEntry>& entries) {
    const float scale = scale_for(greatest_in(entries));
    append_short(bytes, entries.size());
    append_float(bytes, scale);
    std::uint64_t before = 0;
    for (const LampEntry& entry : entries) {
        const std::uint64_t key = entry.key() >> 1;
        append_short(bytes, key - before);
        before = key;
        for (const float channel : entry.light) append_number(bytes, to_half(channel / scale));
    }
}

/// Whether a scale of a file is one of scale_for().
bool is_scale(float scale) { return scale >= 0x1p-100F && scale <= 0x1p100F; }

bool take_entries(ByteReader& reader, std::uint32_t lamps, std::vector<LampEntry>& entries) {
    constexpr std::size_t least_bytes = 7;
    const std::uint64_t count = reader.short_number();
    const float scale = reader.real();
    if (!is_scale(scale) || !reader.has(count, least_bytes)) return false;
    entries.reserve(static_cast<std::size_t>(count));
    std::uint64_t key = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t step = reader.short_number();
        if ((i > 0 && step == 0) || step >= std::uint64_t{tile_pixels} << 32) return false;
        key += step;
        LampEntry entry;
        entry.lamp = static_cast<std::uint32_t>(key);
        if (entry.lamp >= lamps || key >> 32 >= tile_pixels) return false;
        entry.pixel = static_cast<std::uint8_t>(key >> 32);
        for (float& channel : entry.light) {
            const auto half = reader.number<std::uint16_t>();
            if (!is_finite_half(half)) return false;
            channel = from_half(half) * scale;
        }
        entries.push_back(entry);
    }
    return reader.good();
}

bool take_nodes(ByteReader& reader, std::uint32_t lamps, TileRecords& tile) {
    const std::uint64_t count = reader.short_number();
    tile.scale = reader.real();
    if (!is_scale(tile.scale) || !reader.has(count, 2 + 2 * 3 * tile_pixels)) return false;
    std::uint64_t at = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t gap = reader.short_number(), size = reader.short_number();
        if (gap > lamps || size == 0 || size > lamps || at + gap + size > lamps) return false;
        tile.nodes.push_back(
            {static_cast<std::uint32_t>(at + gap), static_cast<std::uint32_t>(at + gap + size)});
        at += gap + size;
    }
    if (!reader.has(count, 2 * 3 * tile_pixels)) return false;
    tile.light.reserve(static_cast<std::size_t>(count) * 3 * tile_pixels);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) * 3 * tile_pixels; ++i) {
        tile.light.push_back(reader.number<std::uint16_t>());
        if (!is_finite_half(tile.light.back())) return false;
    }
    return reader.good();
}

bool in_a_node(const TileRecords& tile, std::uint32_t lamp) {
    const auto after = std::ranges::upper_bound(tile.nodes, lamp, {}, &LampRange::first);
    return after != tile.nodes.begin() && lamp < after[-1].last;
}

}  // namespace

void round_to_file(TileRecords& tile, const std::vector<TilePlanes>& light_of_nodes) {
    float greatest = 0;
    for (const TilePlanes& planes : light_of_nodes)
        for (const float value : planes) greatest = std::max(greatest, std::abs(value));
    tile.scale = scale_for(greatest);
    tile.light.clear();
    for (const TilePlanes& planes : light_of_nodes)
        for (const float value : planes) tile.light.push_back(to_half(value / tile.scale));
    round_entries(tile.own);
    round_entries(tile.residual);
}

void append_tile(std::string& bytes, const TileRecords& tile) {
    append_short(bytes, tile.nodes.size());
    append_float(bytes, tile.scale);
    std::uint32_t at = 0;
    for (const LampRange& node : tile.nodes) {
        append_short(bytes, node.first - at);
        append_short(bytes, node.size());
        at = node.last;
    }
    for (const std::uint16_t half : tile.light) append_number(bytes, half);
    append_entries(bytes, tile.own);
    append_entries(bytes, tile.residual);
    append_number(bytes,
                  static_cast<std::uint8_t>((tile.rest ? 1 : 0) + (tile.seen_in_nodes ? 2 : 0)));
    if (tile.rest)
        for (const float value : *tile.rest) append_float(bytes, value);
}

std::optional<TileRecords> take_tile(std::string_view& bytes, std::uint32_t lamps) {
    ByteReader reader(bytes);
    TileRecords tile;
    if (!take_nodes(reader, lamps, tile) || !take_entries(reader, lamps, tile.own) ||
        !take_entries(reader, lamps, tile.residual))
        return std::nullopt;
    for (const LampEntry& entry : tile.residual)
        if (!in_a_node(tile, entry.lamp)) return std::nullopt;
    const auto marks = reader.number<std::uint8_t>();
    if (marks > 3) return std::nullopt;
    tile.seen_in_nodes = marks >= 2;
    if (marks % 2 == 1)
        for (float& value : tile.rest.emplace()) {
            value = reader.real();
            if (!std::isfinite(value)) return std::nullopt;
        }
    if (!reader.good()) return std::nullopt;
    bytes = reader.left();
    return tile;
}

}  // namespace candelabra
