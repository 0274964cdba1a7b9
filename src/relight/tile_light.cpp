// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/tile_light.h"

#include "base/order.h"
#include "base/random.h"
#include "relight/byte_stream.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

/// Share of the room of nodes and their residual that nodes may have, and their greatest number.
constexpr double share_of_nodes = 0.6;
constexpr std::size_t most_nodes = 64;

void add_light(TilePlanes& planes, const LampEntry& entry) {
    for (std::size_t c = 0; c < 3; ++c) planes[c * tile_pixels + entry.pixel] += entry.light[c];
}

double random_of(std::uint64_t seed) { return static_cast<double>(mix(seed) >> 11) * 0x1p-53; }

/// The light that a node of one lamp has in its pixels, as entries.
void append_entries_of(const LampRange& range, const TilePlanes& planes,
                       std::vector<LampEntry>& entries) {
    for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel) {
        LampEntry entry{range.first, static_cast<std::uint8_t>(pixel), false, {}};
        for (std::size_t c = 0; c < 3; ++c) entry.light[c] = planes[c * tile_pixels + pixel];
        if (entry.size() > 0) entries.push_back(entry);
    }
}

void append_entries_to(std::string& bytes, const std::vector<LampEntry>& entries) {
    append_short(bytes, entries.size());
    for (const LampEntry& entry : entries) {
        append_number(bytes, entry.lamp);
        append_number(bytes, entry.pixel);
        append_number(bytes, static_cast<std::uint8_t>(entry.seen ? 1 : 0));
        for (const float channel : entry.light) append_float(bytes, channel);
    }
}

bool take_entries_of(ByteReader& reader, std::uint32_t lamps, std::vector<LampEntry>& entries) {
    constexpr std::size_t own_bytes = 18;
    const std::uint64_t count = reader.short_number();
    if (!reader.has(count, own_bytes)) return false;
    for (std::uint64_t i = 0; i < count; ++i) {
        LampEntry& entry = entries.emplace_back();
        entry.lamp = reader.number<std::uint32_t>();
        entry.pixel = reader.number<std::uint8_t>();
        entry.seen = reader.number<std::uint8_t>() != 0;
        for (float& channel : entry.light) channel = reader.real();
        if (entry.lamp >= lamps || entry.pixel >= tile_pixels || !std::isfinite(entry.size()))
            return false;
    }
    return reader.good();
}

}  // namespace

void TileLight::append_to(std::string& bytes) const {
    append_short(bytes, nodes_.size());
    for (const Node& node : nodes_) {
        append_number(bytes, node.range.first);
        append_number(bytes, node.range.last);
        for (const float value : node.light) append_float(bytes, value);
    }
    for (const auto* entries : {&own_, &residual_, &fresh_}) append_entries_to(bytes, *entries);
    append_number(bytes, static_cast<std::uint8_t>(seen_in_nodes_ ? 1 : 0));
}

std::optional<TileLight> TileLight::take(std::string_view& bytes, std::uint32_t lamps) {
    ByteReader reader(bytes);
    TileLight tile;
    const std::uint64_t nodes = reader.short_number();
    if (!reader.has(nodes, 2 * sizeof(std::uint32_t) + sizeof(TilePlanes))) return std::nullopt;
    for (std::uint64_t i = 0; i < nodes; ++i) {
        Node node;
        node.range.first = reader.number<std::uint32_t>();
        node.range.last = reader.number<std::uint32_t>();
        const std::uint32_t before = tile.nodes_.empty() ? 0 : tile.nodes_.back().range.last;
        if (node.range.first < before || node.range.last <= node.range.first ||
            node.range.last > lamps)
            return std::nullopt;
        for (float& value : node.light) {
            value = reader.real();
            if (!std::isfinite(value)) return std::nullopt;
        }
        tile.nodes_.push_back(node);
    }
    for (auto* entries : {&tile.own_, &tile.residual_, &tile.fresh_})
        if (!take_entries_of(reader, lamps, *entries)) return std::nullopt;
    const auto mark = reader.number<std::uint8_t>();
    if (!reader.good() || mark > 1) return std::nullopt;
    tile.seen_in_nodes_ = mark == 1;
    bytes = reader.left();
    return tile;
}

void TileLight::add(std::uint32_t lamp, std::size_t pixel, const Rgb& light, bool seen) {
    const double size = std::abs(light.r) + std::abs(light.g) + std::abs(light.b);
    constexpr double most = 1e30;
    if (!(size > 0) || !(size < most)) return;
    fresh_.push_back(
        {lamp,
         static_cast<std::uint8_t>(pixel),
         seen,
         {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b)}});
}

TileLight::Node* TileLight::node_of(std::uint32_t lamp) {
    const auto after = std::ranges::upper_bound(nodes_, lamp, {},
                                                [](const Node& node) { return node.range.first; });
    return after != nodes_.begin() && lamp < after[-1].range.last ? &after[-1] : nullptr;
}

/// Brings light to the node of its lamp; without one, it stays by itself.
void TileLight::place(const LampEntry& entry) {
    Node* const node = entry.seen ? nullptr : node_of(entry.lamp);
    if (!node) return own_.push_back(entry);
    add_light(node->light, entry);
    if (node->range.size() > 1) residual_.push_back(entry);
}

void TileLight::settle(const LampList& lamps, std::size_t room, std::uint64_t seed) {
    for (const LampEntry& entry : summed(std::exchange(fresh_, {}))) place(entry);
    own_ = summed(std::move(own_));
    residual_ = summed(std::move(residual_));
    if (bytes() > room) shrink(lamps, room, seed);
}

/// Leaves the strongest of the lamps that rays met by themselves.
void TileLight::demote(std::size_t most) {
    std::vector<float> sizes;
    for (const LampEntry& entry : own_)
        if (entry.seen) sizes.push_back(entry.size());
    if (sizes.size() <= most) return;
    seen_in_nodes_ = true;
    std::ranges::stable_sort(sizes, std::greater<>());
    const float least = most > 0 ? sizes[most - 1] : sizes[0];
    std::size_t left = most;
    for (LampEntry& entry : own_)
        if (entry.seen && (left == 0 || entry.size() < least))
            entry.seen = false;
        else if (entry.seen)
            --left;
    for (const LampEntry& entry : summed(std::exchange(own_, {}))) place(entry);
}

std::vector<LampAtom> TileLight::atoms() const {
    std::vector<LampAtom> all;
    for (const Node& node : nodes_) {
        double light = 0;
        for (const float value : node.light) light += static_cast<double>(std::abs(value));
        all.push_back({node.range, light});
    }
    std::vector<LampAtom> single;
    for (const LampEntry& entry : own_)
        if (!entry.seen)
            single.push_back({{entry.lamp, entry.lamp + 1},
                              static_cast<double>(std::abs(entry.light[0])) +
                                  static_cast<double>(std::abs(entry.light[1])) +
                                  static_cast<double>(std::abs(entry.light[2]))});
    const auto first_of = [](const LampAtom& atom) { return atom.range.first; };
    sort_stably(single, {}, first_of);
    for (const LampAtom& atom : single)
        if (!all.empty() && all.back().range == atom.range)
            all.back().light += atom.light;
        else
            all.push_back(atom);
    sort_stably(all, {}, first_of);
    return all;
}

/// Sums all light by the nodes, which hold all atoms. A lamp that is a node by itself and lights
/// few pixels stays as it is.
void TileLight::gather(const std::vector<LampRange>& ranges) {
    std::vector<Node> old = std::exchange(nodes_, {});
    for (const LampRange& range : ranges) nodes_.push_back({range, {}});
    for (const Node& node : old) {
        Node& now = *node_of(node.range.first);
        for (std::size_t i = 0; i < node.light.size(); ++i) now.light[i] += node.light[i];
        if (node.range.size() == 1 && now.range.size() > 1)
            append_entries_of(node.range, node.light, residual_);
    }
    for (const LampEntry& entry : std::exchange(own_, {})) place(entry);
    std::vector<Node> kept;
    for (const Node& node : nodes_) {
        std::vector<LampEntry> entries;
        if (node.range.size() == 1) append_entries_of(node.range, node.light, entries);
        const bool few = node.range.size() == 1 && entries.size() * entry_bytes < node_bytes;
        if (few)
            own_.insert(own_.end(), entries.begin(), entries.end());
        else
            kept.push_back(node);
    }
    nodes_ = std::move(kept);
    own_ = summed(std::move(own_));
    residual_ = summed(std::move(residual_));
}

void TileLight::shrink(const LampList& lamps, std::size_t room, std::uint64_t seed) {
    demote(room / 2 / entry_bytes);
    std::size_t seen = 0;
    for (const LampEntry& entry : own_) seen += entry.seen ? entry_bytes : 0;
    const double left = static_cast<double>(room - std::min(room, seen));
    const auto nodes = static_cast<std::size_t>(share_of_nodes * left / node_bytes);
    gather(chosen_nodes(lamps, atoms(), std::clamp(nodes, std::size_t{1}, most_nodes)));
    const std::size_t taken = nodes_.size() * node_bytes + bytes_of_own();
    thin(residual_, (room - std::min(room, taken)) / entry_bytes, random_of(seed));
}

TileRecords TileLight::finished(const LampList& lamps, const TilePixels& pixels, std::size_t room,
                                std::uint64_t seed) {
    settle(lamps, room, seed);
    std::array<Rgb, tile_pixels> light{}, size{};
    const auto count = [&](std::size_t pixel, std::size_t channel, float value) {
        const int c = static_cast<int>(channel);
        light[pixel][c] += static_cast<double>(value);
        size[pixel][c] += static_cast<double>(std::abs(value));
    };
    for (const Node& node : nodes_)
        for (std::size_t i = 0; i < node.light.size(); ++i)
            count(i % tile_pixels, i / tile_pixels, node.light[i]);
    for (const LampEntry& entry : own_)
        for (std::size_t c = 0; c < 3; ++c) count(entry.pixel, c, entry.light[c]);
    TileRecords tile;
    TilePlanes rest{};
    bool any = false;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const std::size_t pixel = i % tile_pixels;
        const int c = static_cast<int>(i / tile_pixels);
        if (!(pixels.weight[pixel] > 0)) continue;
        const double all = pixels.mean[pixel][c] * pixels.weight[pixel];
        const double left = all - light[pixel][c];
        // Sums of floats are not exact.
        constexpr double rounding = 1e-5;
        if (std::abs(left) <= rounding * (size[pixel][c] + std::abs(all))) continue;
        rest[i] = static_cast<float>(left / pixels.weight[pixel]);
        any = true;
    }
    if (any) tile.rest = rest;
    // Lamps in crowds are told from those by themselves, whether there is room for all or not.
    shrink(lamps, room - std::min(room, any ? rest_bytes : 0), seed);
    const auto mean_of = [&](float value, std::size_t pixel) {
        const double weight = pixels.weight[pixel];
        return weight > 0 ? static_cast<float>(static_cast<double>(value) / weight) : 0.0F;
    };
    std::vector<TilePlanes> planes;
    for (const Node& node : nodes_) {
        tile.nodes.push_back(node.range);
        TilePlanes& made = planes.emplace_back();
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = mean_of(node.light[i], i % tile_pixels);
    }
    for (auto [from, to] : {std::pair{&own_, &tile.own}, {&residual_, &tile.residual}})
        for (LampEntry entry : *from) {
            for (float& channel : entry.light) channel = mean_of(channel, entry.pixel);
            to->push_back(entry);
        }
    tile.seen_in_nodes = seen_in_nodes_;
    round_to_file(tile, planes);
    *this = TileLight();
    return tile;
}

}  // namespace candelabra
