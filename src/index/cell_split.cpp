// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/cell_split.h"

#include "base/target_clones.h"
#include "index/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candelabra {

namespace {

/// Maximum number of items for which all ends of boxes are tried as planes; more are binned.
constexpr std::size_t sweep_limit = 8;
constexpr int max_cell_bins = 32;
/// Fewer items than this are put into half as many bins.
constexpr double few_in_cell = 64;
/// Fraction of the cell by which boxes may cross a plane and still count as on one side, so that
/// touching items are not duplicated.
constexpr double touching = 0x1p-20;

/// Extent of the cell along one axis.
struct CellAxis {
    int number;
    double low, high;
    double tolerance;

    CellAxis(int axis, const Box& box, double slack)
        : number(axis),
          low(box.low[axis]),
          high(box.high[axis]),
          tolerance(slack + touching * (high - low)) {}
};

/// Keeps the plane of least cost.
class BestPlane {
public:
    BestPlane(std::size_t count, const Box& box, const TreeSettings& costs)
        : costs_(costs),
          count_(static_cast<double>(count)),
          item_cost_(costs.group_cost / costs.group) {
        const double whole = area(box);
        min_saving_ = (cost_of_items(count_, costs) - costs.node_cost) * whole;
        // Many items have many more planes to come, which will separate them again.
        const double late = std::min(1.0, few_in_cell / count_);
        reference_cost_ = costs.reference_cost * whole * late;
    }

    bool can_pay() const { return min_saving_ > 0; }

    /// Considers a plane with these numbers of items on its sides, whose extents it does not cut
    /// yet.
    [[gnu::always_inline]] void consider(const CellAxis& axis, double position, double below,
                                         double above, const Extent& low, const Extent& high) {
        if (below == count_ && above == count_) return;
        Box below_box = low.box(), above_box = high.box();
        below_box.high[axis.number] = std::min(below_box.high[axis.number], position);
        above_box.low[axis.number] = std::max(above_box.low[axis.number], position);
        const double first = area(below_box), second = area(above_box);
        const double twice = reference_cost_ * (below + above - count_);
        // Most planes can be rejected without rounding up to groups.
        if (!(item_cost_ * (first * below + second * above) + twice < min_saving_)) return;
        const double cost =
            first * cost_of_items(below, costs_) + second * cost_of_items(above, costs_) + twice;
        if (!(cost < min_saving_)) return;
        min_saving_ = cost;
        best_ = {axis.number, position, axis.tolerance};
    }
    const CellSplit& best() const { return best_; }

private:
    const TreeSettings& costs_;
    double count_, item_cost_, min_saving_, reference_cost_;
    CellSplit best_;
};

/// Tries planes at all ends of boxes.
class CellSweep {
public:
    explicit CellSweep(std::span<const PrimRef> fragments) : count_(fragments.size()) {
        for (std::size_t i = 0; i < count_; ++i) boxes_[i] = fragments[i].box;
    }

    void run(const CellAxis& axis, BestPlane& best) {
        Order lows, highs;
        for (std::size_t i = 0; i < count_; ++i) {
            lows[i] = {boxes_[i].low[axis.number] + axis.tolerance, static_cast<std::uint8_t>(i)};
            highs[i] = {boxes_[i].high[axis.number] - axis.tolerance, static_cast<std::uint8_t>(i)};
        }
        sort(lows);
        sort(highs);
        std::array<Extent, sweep_limit + 1> below, above;
        for (std::size_t i = 0; i < count_; ++i) {
            below[i + 1] = below[i];
            below[i + 1].join(Extent::of(boxes_[lows[i].second]));
        }
        for (std::size_t i = count_; i-- > 0;) {
            above[i] = i + 1 < count_ ? above[i + 1] : Extent();
            above[i].join(Extent::of(boxes_[highs[i].second]));
        }
        // Just behind the end of a box, and just before the beginning of one.
        const auto try_all = [&](const Order& ends, double offset) {
            std::size_t begun = 0, ended = 0;
            for (std::size_t i = 0; i < count_; ++i) {
                const double plane = ends[i].first + offset;
                while (begun < count_ && lows[begun].first < plane) ++begun;
                while (ended < count_ && highs[ended].first <= plane) ++ended;
                if (begun == 0 || ended == count_) continue;
                best.consider(axis, plane, static_cast<double>(begun),
                              static_cast<double>(count_ - ended), below[begun], above[ended]);
            }
        };
        try_all(highs, axis.tolerance);
        try_all(lows, -axis.tolerance);
    }

private:
    using Order = std::array<std::pair<double, std::uint8_t>, sweep_limit>;

    /// Insertion sort: there are few items.
    void sort(Order& ends) const {
        for (std::size_t i = 1; i < count_; ++i) {
            const auto end = ends[i];
            std::size_t place = i;
            for (; place > 0 && end.first < ends[place - 1].first; --place)
                ends[place] = ends[place - 1];
            ends[place] = end;
        }
    }

    std::array<Box, sweep_limit> boxes_;
    std::size_t count_;
};

struct CellBin {
    Extent begun, ended;  ///< of the boxes that begin in the bin, and of those that end in it
    std::uint32_t begins = 0, ends = 0;
};

/// Tries planes between bins of equal width.
[[gnu::always_inline]] inline void try_bins(std::span<const PrimRef> fragments,
                                            const std::array<CellAxis, 3>& axes, BestPlane& best) {
    const int bins =
        static_cast<double>(fragments.size()) < few_in_cell ? max_cell_bins / 2 : max_cell_bins;
    std::array<std::array<CellBin, max_cell_bins>, 3> filled;
    std::array<double, 3> scale;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        scale[axis] = bins / (axes[axis].high - axes[axis].low);
        if (!(scale[axis] < Extent::infinity)) scale[axis] = 0;
    }
    for (const PrimRef& f : fragments) {
        const Extent extent = Extent::of(f.box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const CellAxis& along = axes[axis];
            const auto bin_of = [&](double x) {
                return static_cast<int>((x - along.low) * scale[axis]);
            };
            const int first = bin_of(f.box.low[along.number] + along.tolerance);
            const int last = bin_of(f.box.high[along.number] - along.tolerance);
            const auto begin = static_cast<std::size_t>(std::min(first, bins - 1));
            const auto end =
                std::max(begin, static_cast<std::size_t>(std::clamp(last, 0, bins - 1)));
            filled[axis][begin].begun.join(extent);
            ++filled[axis][begin].begins;
            filled[axis][end].ended.join(extent);
            ++filled[axis][end].ends;
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (scale[axis] == 0) continue;
        std::array<Extent, max_cell_bins> from;  ///< bounds of the boxes that end in this bin and
                                                 ///< those above
        Extent above, below;
        for (int bin = bins - 1; bin > 0; --bin) {
            const auto i = static_cast<std::size_t>(bin);
            above.join(filled[axis][i].ended);
            from[i] = above;
        }
        std::uint32_t begun = 0, ended = 0;
        for (int bin = 1; bin < bins; ++bin) {
            const auto i = static_cast<std::size_t>(bin);
            below.join(filled[axis][i - 1].begun);
            begun += filled[axis][i - 1].begins;
            ended += filled[axis][i - 1].ends;
            if (begun == 0 || ended == fragments.size()) continue;
            best.consider(axes[axis], axes[axis].low + bin / scale[axis], begun,
                          static_cast<double>(fragments.size() - ended), below, from[i]);
        }
    }
}

}  // namespace

CANDELABRA_TARGET_CLONES CellSplit find_cell_split(std::span<const PrimRef> fragments,
                                                   const Box& box, const TreeSettings& costs,
                                                   double slack) {
    BestPlane best(fragments.size(), box, costs);
    if (!best.can_pay()) return {};
    const std::array axes{CellAxis(0, box, slack), CellAxis(1, box, slack),
                          CellAxis(2, box, slack)};
    if (fragments.size() > sweep_limit) {
        try_bins(fragments, axes, best);
    } else {
        CellSweep sweep(fragments);
        for (const CellAxis& axis : axes) sweep.run(axis, best);
    }
    return best.best();
}

CellSides divide(std::span<const PrimRef> fragments, const CellSplit& split, const ItemPart& part,
                 double slack) {
    const auto part_in = [&](const PrimRef& f, const Box& side) -> Box {
        const Box box = part ? part(f.item, side) : side;
        if (box.empty()) return {};
        return clip(Box{box.low - Vec3(slack), box.high + Vec3(slack)}, f.box);
    };
    std::size_t below = 0, above = 0;
    for (const PrimRef& f : fragments) {
        const bool over = split.reaches_above(f.box);
        above += over;
        below += !over || split.reaches_below(f.box);
    }
    CellSides sides;
    sides.below.fragments.reserve(below);
    sides.above.fragments.reserve(above);
    const auto put = [](CellSide& side, const Box& box, const PrimRef& f) {
        side.fragments.push_back({box, f.item});
        side.box = join(side.box, box);
    };
    for (const PrimRef& f : fragments) {
        if (!split.reaches_above(f.box)) {
            put(sides.below, f.box, f);
        } else if (!split.reaches_below(f.box)) {
            put(sides.above, f.box, f);
        } else {
            Box lower = f.box, upper = f.box;
            lower.high[split.axis] = upper.low[split.axis] = split.position;
            lower = part_in(f, lower);
            upper = part_in(f, upper);
            if (!lower.empty()) put(sides.below, lower, f);
            if (!upper.empty()) put(sides.above, upper, f);
        }
    }
    return sides;
}

}  // namespace candelabra
