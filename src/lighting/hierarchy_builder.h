// SPDX-License-Identifier: GPL-3.0-or-later
// Builds a binary hierarchy of luminaires from the top. A node is cut across one axis, where both
// parts together cost least; where to cut is tried at the borders of bins of equal size. The cost
// is the caller's.
#pragma once

#include "base/order.h"
#include "base/parallel.h"
#include "lighting/pick.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

/// The cost of the parts into which a node may be cut. Number is that of places; an Item is one
/// luminaire, and a Sum are those of one part.
template <class T>
concept HierarchyCost = requires(const T& cost, const typename T::Item& item, typename T::Sum& sum,
                                 int axis, typename T::Number number) {
    { T::bins } -> std::convertible_to<int>;
    /// Nodes with more luminaires are only cut across their longest side: the axis matters
    /// little there, but time does.
    { T::many } -> std::convertible_to<std::size_t>;
    { cost.place(item, axis) } -> std::same_as<typename T::Number>;
    { cost.light(item) } -> std::same_as<LightIndex>;
    /// The bin of an item that is `number` from the low end of the node's places, whose size is
    /// the other number; rounding may put it beyond the last one.
    { cost.bin(number, number) } -> std::same_as<int>;
    cost.add(sum, item);
    cost.add(sum, std::as_const(sum));
    { cost.of(std::as_const(sum)) } -> std::same_as<double>;
    /// Whether a later side is taken for longer than the one before.
    { T::longer(number, number) } -> std::same_as<bool>;
    /// Factor on the cost of cuts across a side of the second size, where the longest one has
    /// the first.
    { cost.of_side(number, number) } -> std::same_as<double>;
    /// Whether an item is of a second kind, which the root parts from the first.
    { cost.is_second_kind(item) } -> std::same_as<bool>;
};

template <HierarchyCost Cost>
class HierarchyBuilder {
public:
    using Item = typename Cost::Item;
    using Number = typename Cost::Number;

    HierarchyBuilder(std::vector<Item> items, Cost cost)
        : items_(std::move(items)), cost_(std::move(cost)) {}

    /// Calls visit(node, first, middle, end) for each node, with its number in depth-first order,
    /// the range of its items and the first one of its second half; for leaves, which have one
    /// item, middle is end. Halves come after their node. Several threads call it (0: one per
    /// core); with one, all nodes come in order. The tree does not depend on their number, and is
    /// never much deeper than halved_below levels plus those of a balanced one, for any arrangement
    /// of luminaires.
    template <class Visit>
    void build(int threads, const Visit& visit) {
        if (items_.empty()) return;
        const Work all{0, items_.size(), 0, 0};
        if (all.count() <= together) threads = 1;
        run_on_threads(threads, [&] { build(all, threads, visit); });
    }

    /// In the order of the hierarchy's leaves, once it is built.
    const std::vector<Item>& items() const { return items_; }

private:
    /// Depth below which nodes are halved by number, so that luminaires in geometric progression do
    /// not make an endless tree.
    static constexpr int halved_below = 64;

    /// Nodes with at most this number of items are built by one thread.
    static constexpr std::size_t together = 4096;

    struct Work {
        std::size_t first, end;
        int depth;
        std::size_t node;

        std::size_t count() const { return end - first; }
    };
    /// Where the places of a node's items are.
    struct Extent {
        std::array<Number, 3> low, high;

        explicit Extent(Number infinity) : low{infinity, infinity, infinity} {
            high = {-infinity, -infinity, -infinity};
        }
        Number size(int axis) const { return high[axis] - low[axis]; }
        int longest() const {
            int result = 0;
            for (int axis = 1; axis < 3; ++axis)
                if (Cost::longer(size(axis), size(result))) result = axis;
            return result;
        }
    };
    struct Split {
        double cost = std::numeric_limits<double>::infinity();
        int axis = -1;
        int bin = 0;  ///< first one of the second half
    };

    template <class Visit>
    void build(const Work& work, int threads, const Visit& visit) {
        const std::size_t middle = work.count() > 1 ? divide(work) : work.end;
        visit(work.node, work.first, middle, work.end);
        if (work.count() == 1) return;
        // A part of n items has 2n - 1 nodes.
        const Work first{work.first, middle, work.depth + 1, work.node + 1},
            second{middle, work.end, work.depth + 1, work.node + 2 * first.count()};
        if (work.count() <= together) {
            build(first, 1, visit);
            build(second, 1, visit);
        } else {
            run_both(
                threads, [&] { build(first, threads, visit); },
                [&] { build(second, threads, visit); });
        }
    }

    int bin_of(const Item& item, const Extent& extent, int axis) const {
        const Number from_low = cost_.place(item, axis) - extent.low[axis];
        return std::clamp(cost_.bin(from_low, extent.size(axis)), 0, Cost::bins - 1);
    }

    void consider(const Work& work, const Extent& extent, int axis, Split& best) const {
        std::array<typename Cost::Sum, Cost::bins> bin;
        std::array<std::size_t, Cost::bins> count{};
        for (std::size_t i = work.first; i < work.end; ++i) {
            const auto b = static_cast<std::size_t>(bin_of(items_[i], extent, axis));
            cost_.add(bin[b], items_[i]);
            ++count[b];
        }
        std::array<double, Cost::bins> upper{};
        typename Cost::Sum behind;
        for (int b = Cost::bins - 1; b > 0; --b) {
            cost_.add(behind, std::as_const(bin[b]));
            upper[b] = cost_.of(behind);
        }
        const double of_side = cost_.of_side(extent.size(extent.longest()), extent.size(axis));
        typename Cost::Sum before;
        std::size_t below = 0;
        for (int b = 1; b < Cost::bins; ++b) {
            cost_.add(before, std::as_const(bin[b - 1]));
            below += count[b - 1];
            if (below == 0 || below == work.count()) continue;
            const double sum = of_side * (cost_.of(before) + upper[b]);
            if (sum < best.cost) best = {sum, axis, b};
        }
    }

    /// Partitions all items by their kind. Returns the index of the first one of the second half;
    /// nothing if all are of one kind.
    std::optional<std::size_t> divide_by_kind() {
        const auto second =
            std::stable_partition(items_.begin(), items_.end(),
                                  [&](const Item& item) { return !cost_.is_second_kind(item); });
        if (second == items_.begin() || second == items_.end()) return std::nullopt;
        return static_cast<std::size_t>(second - items_.begin());
    }

    /// Partitions the items of a node. Returns the index of the first one of the second half.
    std::size_t divide(const Work& work) {
        if (work.depth == 0)
            if (const auto middle = divide_by_kind()) return *middle;
        Extent extent(std::numeric_limits<Number>::infinity());
        for (std::size_t i = work.first; i < work.end; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                const Number place = cost_.place(items_[i], axis);
                extent.low[axis] = std::min(extent.low[axis], place);
                extent.high[axis] = std::max(extent.high[axis], place);
            }
        const int longest = extent.longest();
        Split best;
        if (work.depth < halved_below)
            for (int axis = 0; axis < 3; ++axis)
                if (extent.size(axis) > 0 && (work.count() <= Cost::many || axis == longest))
                    consider(work, extent, axis, best);
        const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(work.first);
        const auto end = items_.begin() + static_cast<std::ptrdiff_t>(work.end);
        if (best.axis >= 0) {
            const auto middle = std::stable_partition(begin, end, [&](const Item& item) {
                return bin_of(item, extent, best.axis) < best.bin;
            });
            return static_cast<std::size_t>(middle - items_.begin());
        }
        const std::size_t half = work.first + work.count() / 2;
        put_nth(begin, items_.begin() + static_cast<std::ptrdiff_t>(half), end,
                [&](const Item& a, const Item& b) {
                    const Number x = cost_.place(a, longest), y = cost_.place(b, longest);
                    return x != y ? x < y : cost_.light(a) < cost_.light(b);
                });
        return half;
    }

    std::vector<Item> items_;
    Cost cost_;
};

}  // namespace candelabra
