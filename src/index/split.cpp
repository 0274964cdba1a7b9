// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/split.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

/// Up to so many fragments every end of a box is tried; above, the ends are counted in bins.
/// Measured on 10^4 to 10^6 spheres: sweeping everywhere takes four times as long to build and
/// gives rays no measurable gain.
constexpr std::size_t sweep_limit = 12;
constexpr int bin_count = 32;

/// What items cost that are tested in groups: the last ones take the time of a full group, but not
/// its memory. Half way between both was fastest among 10^5 spheres and as many triangles.
double tests(double items, double group) {
    return 0.5 * (items + group * std::ceil(items / group));
}

}  // namespace

/// The cell as seen along one axis: the chance that a ray through the cell meets a slab of it is
/// linear in the slab's thickness.
struct SplitFinder::Axis {
    int number;
    double low, high;
    double end_chance;        ///< of a slab without thickness
    double thickness_chance;  ///< per unit of thickness

    Axis(int axis, const Box& cell) : number(axis), low(cell.low[axis]), high(cell.high[axis]) {
        const Vec3 size = cell.size();
        const double a = size[(axis + 1) % 3];
        const double b = size[(axis + 2) % 3];
        const double total = a * b + size[axis] * (a + b);
        end_chance = a * b / total;
        thickness_chance = (a + b) / total;
    }
};

Split SplitFinder::find(std::span<const Fragment> fragments, const Box& cell) {
    Split best;
    // Cells of no area, or of one that is not a number (coordinates near the limits of double),
    // stay whole.
    if (!(area(cell) > 0 && area(cell) < std::numeric_limits<double>::infinity())) return best;
    best.cost = costs_.intersection * tests(static_cast<double>(fragments.size()), costs_.group);
    const std::array axes = {Axis(0, cell), Axis(1, cell), Axis(2, cell)};
    if (fragments.size() > sweep_limit)
        bin(fragments, axes, best);
    else
        for (const Axis& axis : axes) sweep(fragments, axis, best);
    return best;
}

void SplitFinder::consider(const Axis& axis, double position, double below, double above,
                           Split& best) const {
    if (!(position > axis.low && position < axis.high)) return;
    const double chance_below = axis.end_chance + (position - axis.low) * axis.thickness_chance;
    const double chance_above = axis.end_chance + (axis.high - position) * axis.thickness_chance;
    double cost = costs_.intersection * (chance_below * tests(below, costs_.group) +
                                         chance_above * tests(above, costs_.group));
    if (below == 0 || above == 0) cost *= 1 - costs_.empty_bonus;
    cost += costs_.traversal;
    if (cost < best.cost) best = {axis.number, position, cost};
}

/// The cost is linear between the ends of boxes, so the best plane lies at one of them: just beyond
/// an upper end, or just before a lower one, by so much that this box comes to one side only.
void SplitFinder::sweep(std::span<const Fragment> fragments, const Axis& axis, Split& best) {
    const std::size_t n = fragments.size();
    lows_.resize(n);
    highs_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        lows_[i] = fragments[i].box.low[axis.number];
        highs_[i] = fragments[i].box.high[axis.number];
    }
    std::sort(lows_.begin(), lows_.end());
    std::sort(highs_.begin(), highs_.end());

    const auto try_all = [&](const std::vector<double>& ends, double offset) {
        std::size_t below = 0;
        std::size_t ended = 0;
        for (const double end : ends) {
            const double plane = end + offset;
            while (below < n && reaches_below(lows_[below], plane, slack_)) ++below;
            while (ended < n && !reaches_above(highs_[ended], plane, slack_)) ++ended;
            consider(axis, plane, static_cast<double>(below), static_cast<double>(n - ended), best);
        }
    };
    try_all(highs_, 2 * slack_);
    try_all(lows_, -2 * slack_);
}

/// Planes between bins of equal width, and at both ends of what the cell holds to cut off empty
/// space. Memory is what takes time here: each fragment is read twice, not twice for each axis.
void SplitFinder::bin(std::span<const Fragment> fragments, const std::array<Axis, 3>& axes,
                      Split& best) const {
    Box held;
    for (const Fragment& f : fragments) held = join(held, f.box);
    std::array<double, 3> scale;
    for (int axis = 0; axis < 3; ++axis) {
        scale[axis] = bin_count / (held.high[axis] - held.low[axis]);
        if (!(scale[axis] < std::numeric_limits<double>::infinity())) scale[axis] = 0;
    }
    std::array<std::array<std::uint32_t, bin_count>, 3> starts{}, ends{};
    const auto bin_of = [&](int axis, double x) {
        return static_cast<std::size_t>(
            std::min(static_cast<int>((x - held.low[axis]) * scale[axis]), bin_count - 1));
    };
    for (const Fragment& f : fragments)
        for (int axis = 0; axis < 3; ++axis) {
            ++starts[axis][bin_of(axis, f.box.low[axis])];
            ++ends[axis][bin_of(axis, f.box.high[axis])];
        }
    const double n = static_cast<double>(fragments.size());
    for (const Axis& axis : axes) {
        const double low = held.low[axis.number], high = held.high[axis.number];
        consider(axis, low - 2 * slack_, 0, n, best);
        consider(axis, high + 2 * slack_, n, 0, best);
        if (!(scale[axis.number] > 0)) continue;
        double below = 0;
        double above = n;
        for (int i = 1; i < bin_count; ++i) {
            below += starts[axis.number][static_cast<std::size_t>(i - 1)];
            above -= ends[axis.number][static_cast<std::size_t>(i - 1)];
            consider(axis, low + i / scale[axis.number], below, above, best);
        }
    }
}
