// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_cut.h"

#include "base/order.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// A node that may still be divided, and its atoms.
struct OpenNode {
    double light;
    LampRange range;
    std::size_t first, last;

    bool operator<(const OpenNode& other) const {
        return light < other.light || (light == other.light && range.first > other.range.first);
    }
};

/// The size above which entries are certain to be kept, if `most` are: the sum of the smaller ones,
/// over the number that is left for them.
double size_to_keep(std::span<const LampEntry> entries, std::size_t most) {
    std::vector<float> sizes;
    for (const LampEntry& entry : entries) sizes.push_back(entry.size());
    std::ranges::stable_sort(sizes, std::greater<>());
    double sum = 0;
    for (const float size : sizes) sum += size;
    for (std::size_t i = 0; i < most && i < sizes.size(); ++i) {
        const double left = static_cast<double>(most - i);
        if (static_cast<double>(sizes[i]) * left <= sum) return sum / left;
        sum -= sizes[i];
    }
    return sizes.empty() || most == 0 ? 0 : sizes[std::min(most, sizes.size()) - 1];
}

}  // namespace

std::vector<LampRange> chosen_nodes(const LampList& lamps, std::span<const LampAtom> atoms,
                                    std::size_t most) {
    std::vector<LampRange> chosen;
    std::vector<OpenNode> open;
    const auto take = [&](const LampRange& range, std::size_t first, std::size_t last) {
        if (last - first == 1) chosen.push_back(atoms[first].range);
        if (last - first < 2) return;
        double light = 0;
        for (std::size_t i = first; i < last; ++i) light += atoms[i].light;
        add_to_heap(open, OpenNode{light, range, first, last});
    };
    take({0, lamps.size()}, 0, atoms.size());
    while (!open.empty() && chosen.size() + open.size() < most) {
        const OpenNode node = open.front();
        remove_greatest(open);
        const std::uint32_t middle = lamps.division_of(node.range);
        const auto between =
            std::partition_point(atoms.begin() + static_cast<std::ptrdiff_t>(node.first),
                                 atoms.begin() + static_cast<std::ptrdiff_t>(node.last),
                                 [&](const LampAtom& atom) { return atom.range.first < middle; });
        const auto split = static_cast<std::size_t>(between - atoms.begin());
        take({node.range.first, middle}, node.first, split);
        take({middle, node.range.last}, split, node.last);
    }
    for (const OpenNode& node : open) chosen.push_back(node.range);
    sort_stably(chosen, {}, &LampRange::first);
    return chosen;
}

float LampEntry::size() const {
    return std::max({std::abs(light[0]), std::abs(light[1]), std::abs(light[2])});
}

void thin(std::vector<LampEntry>& entries, std::size_t most, double random) {
    if (entries.size() <= most) return;
    const double sure = size_to_keep(entries, most);
    std::vector<LampEntry> kept;
    double at = random;
    for (LampEntry& entry : entries) {
        if (!(entry.size() > 0)) continue;
        const double chance = sure > 0 ? std::min(1.0, entry.size() / sure) : most > 0 ? 1.0 : 0.0;
        // Equal steps through the sum of the chances: one draw for all of them.
        at += chance;
        if (at < 1 || kept.size() == most) continue;
        at -= 1;
        for (float& channel : entry.light)
            channel = static_cast<float>(static_cast<double>(channel) / chance);
        kept.push_back(entry);
    }
    entries = std::move(kept);
}

std::vector<LampEntry> summed(std::vector<LampEntry> entries) {
    sort_stably(entries, {}, &LampEntry::key);
    std::size_t count = 0;
    for (std::size_t i = 0; i < entries.size();) {
        std::array<double, 3> sum{};
        std::size_t j = i;
        for (; j < entries.size() && entries[j].key() == entries[i].key(); ++j)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(entries[j].light[c]);
        LampEntry& made = entries[count++];
        made = entries[i];
        for (std::size_t c = 0; c < 3; ++c) made.light[c] = static_cast<float>(sum[c]);
        i = j;
    }
    entries.resize(count);
    return entries;
}

}  // namespace candelabra
