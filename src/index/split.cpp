// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/split.h"

#include "base/infinity.h"
#include "base/target_clones.h"
#include "index/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candelabra {

namespace {

constexpr int max_bins = 16;
/// Fewer items than this are put into half as many bins.
constexpr std::size_t few = 32;

struct Bin {
    Extent extent;
    std::uint32_t count = 0;
};

/// Bounds of the items' centres, in doubled coordinates.
[[gnu::always_inline]] inline Box centres(std::span<const PrimRef> fragments) {
    Vec3 low(infinity), high(-infinity);
    for (const PrimRef& f : fragments) {
        const Vec3 doubled = f.box.low + f.box.high;
        low = glm::min(low, doubled);
        high = glm::max(high, doubled);
    }
    return {low, high};
}

}  // namespace

double cost_of_items(double items, const TreeSettings& costs) {
    const double groups = items / costs.group;
    // On the oldest machines std::ceil is a function call.
    double whole = static_cast<std::int32_t>(groups);
    if (whole < groups) ++whole;
    return costs.group_cost * 0.5 * (groups + whole);
}

CANDELABRA_TARGET_CLONES Split find_split(std::span<const PrimRef> fragments, const Box& box,
                                          const TreeSettings& costs, bool forced) {
    // Two boxes need at least one node.
    const auto items = static_cast<double>(fragments.size());
    const double together = cost_of_items(items, costs) - costs.node_cost;
    if (!forced && !(together > 0)) return {};

    const Box held = centres(fragments);
    const int bins = fragments.size() < few ? max_bins / 2 : max_bins;
    std::array<double, 3> scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Slightly less, so that the last centre falls into the last bin.
        scale[axis] = bins * (1 - 0x1p-40) / held.size()[static_cast<int>(axis)];
        if (!(scale[axis] < infinity)) scale[axis] = 0;  // all centres have one coordinate
    }
    std::array<std::array<Bin, max_bins>, 3> filled;
    for (const PrimRef& f : fragments) {
        const Extent extent = Extent::of(f.box);
        const Vec3 doubled = f.box.low + f.box.high;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<int>(axis);
            const auto bin = static_cast<std::size_t>(
                static_cast<int>((doubled[at] - held.low[at]) * scale[axis]));
            filled[axis][bin].extent.join(extent);
            ++filled[axis][bin].count;
        }
    }

    const double whole = area(box);
    double least = forced ? infinity : together * whole;
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (scale[axis] == 0) continue;
        std::array<Extent, max_bins> from;  ///< bounds of this bin and those above
        Extent above;
        for (int bin = bins - 1; bin > 0; --bin) {
            const auto i = static_cast<std::size_t>(bin);
            above.join(filled[axis][i].extent);
            from[i] = above;
        }
        Extent below;
        std::uint32_t count = 0;
        for (int bin = 1; bin < bins; ++bin) {
            const auto i = static_cast<std::size_t>(bin);
            if (filled[axis][i - 1].count == 0) continue;
            below.join(filled[axis][i - 1].extent);
            count += filled[axis][i - 1].count;
            const double n = count;
            if (n == items) break;
            const double cost = area(below.box()) * cost_of_items(n, costs) +
                                area(from[i].box()) * cost_of_items(items - n, costs);
            if (!(cost < least)) continue;
            least = cost;
            best = {static_cast<int>(axis),
                    held.low[static_cast<int>(axis)],
                    scale[axis],
                    bin,
                    below.box(),
                    from[i].box()};
        }
    }
    return best;
}

}  // namespace candelabra
