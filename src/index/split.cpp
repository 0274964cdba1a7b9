// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/split.h"

#include "base/every_machine.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace {

/// Up to so many fragments every end of a box is tried; above, the ends are counted in bins.
/// Measured on 10^4 to 10^6 spheres: sweeping everywhere takes four times as long to build and
/// gives rays no measurable gain.
constexpr std::size_t sweep_limit = 12;
constexpr int most_bins = 32;
/// Half as many bins will do for so many fragments or fewer: a tenth less time to build, and rays
/// are as fast.
constexpr std::size_t few_fragments = 48;

/// What items cost that are tested in groups: the last ones take the time of a full group, but not
/// its memory. Half way between both was fastest among 10^5 spheres and as many triangles.
double tests(double items, double group) {
    const double groups = items / group;
    // std::ceil is a call on machines of the oldest kind.
    double whole = static_cast<std::int32_t>(groups);
    if (whole < groups) ++whole;
    return 0.5 * (items + group * whole);
}

/// Both ends of a box along three axes side by side, as they are stored: four lanes and two.
struct Ends {
    using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
    using Two [[gnu::vector_size(2 * sizeof(double))]] = double;

    Four four;  ///< the lower ends, the upper one of x
    Two two;    ///< the upper ends of y and z

    [[gnu::always_inline]] static Ends of(const Fragment& f) {
        Ends ends;
        static_assert(sizeof f.box == sizeof ends.four + sizeof ends.two);
        std::memcpy(&ends.four, &f.box, sizeof ends.four);
        std::memcpy(&ends.two, &f.box.high.y, sizeof ends.two);
        return ends;
    }
};

[[gnu::always_inline]] inline Box held_by(std::span<const Fragment> fragments) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Ends least = {Ends::Four{} + infinity, {}};
    Ends most = {-least.four, Ends::Two{} - infinity};
    for (const Fragment& f : fragments) {
        const Ends at = Ends::of(f);
        least.four = at.four < least.four ? at.four : least.four;
        most.four = at.four > most.four ? at.four : most.four;
        most.two = at.two > most.two ? at.two : most.two;
    }
    return {{least.four[0], least.four[1], least.four[2]},
            {most.four[3], most.two[0], most.two[1]}};
}

/// How many fragments start and end in each bin, of equal width along each axis.
struct Bins {
    int count;
    std::array<double, 3> scale;  ///< bins for each unit of length; 0: all are in one
    std::array<std::array<std::uint32_t, most_bins>, 3> starts, ends;

    [[gnu::always_inline]] inline Bins(std::span<const Fragment> fragments, const Box& held)
        : count(fragments.size() > few_fragments ? most_bins : most_bins / 2) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double low = held.low[static_cast<int>(axis)];
            scale[axis] = count / (held.high[static_cast<int>(axis)] - low);
            if (!(scale[axis] < std::numeric_limits<double>::infinity())) scale[axis] = 0;
        }
        const Ends from = {{held.low.x, held.low.y, held.low.z, held.low.x},
                           {held.low.y, held.low.z}};
        const Ends factor = {{scale[0], scale[1], scale[2], scale[0]}, {scale[1], scale[2]}};
        // Two sets in turns, as neighbours often fall into the same bin.
        std::array<std::array<std::array<std::uint32_t, most_bins>, 6>, 2> found{};
        std::size_t turn = 0;
        using Four [[gnu::vector_size(4 * sizeof(std::int32_t))]] = std::int32_t;
        using Two [[gnu::vector_size(2 * sizeof(std::int32_t))]] = std::int32_t;
        const int last = count - 1;
        for (const Fragment& f : fragments) {
            const Ends at = Ends::of(f);
            Four four = __builtin_convertvector((at.four - from.four) * factor.four, Four);
            Two two = __builtin_convertvector((at.two - from.two) * factor.two, Two);
            four = four < last ? four : Four{} + last;
            two = two < last ? two : Two{} + last;
            const auto count_in = [&](std::size_t end, int bin) {
                ++found[turn][end][static_cast<std::size_t>(bin)];
            };
            for (std::size_t i = 0; i < 4; ++i) count_in(i, four[i]);
            for (std::size_t i = 0; i < 2; ++i) count_in(4 + i, two[i]);
            turn ^= 1;
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < most_bins; ++i) {
                starts[axis][i] = found[0][axis][i] + found[1][axis][i];
                ends[axis][i] = found[0][axis + 3][i] + found[1][axis + 3][i];
            }
    }
};

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

[[gnu::always_inline]] inline void SplitFinder::consider(const Axis& axis, double position,
                                                         double below, double above,
                                                         Split& best) const {
    if (!(position > axis.low && position < axis.high)) return;
    const double chance_below = axis.end_chance + (position - axis.low) * axis.thickness_chance;
    const double chance_above = axis.end_chance + (axis.high - position) * axis.thickness_chance;
    const double kept =
        costs_.intersection * (below == 0 || above == 0 ? 1 - costs_.empty_bonus : 1);
    // Most planes are no better even without what rounding up to groups adds.
    if (kept * (chance_below * below + chance_above * above) + costs_.traversal >= best.cost)
        return;
    const double cost = kept * (chance_below * tests(below, costs_.group) +
                                chance_above * tests(above, costs_.group)) +
                        costs_.traversal;
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
CANDELABRA_EVERY_MACHINE void SplitFinder::bin(std::span<const Fragment> fragments,
                                               const std::array<Axis, 3>& axes, Split& best) const {
    const Box held = held_by(fragments);
    const Bins bins(fragments, held);
    const double n = static_cast<double>(fragments.size());
    for (const Axis& axis : axes) {
        const auto number = static_cast<std::size_t>(axis.number);
        const double low = held.low[axis.number], high = held.high[axis.number];
        consider(axis, low - 2 * slack_, 0, n, best);
        consider(axis, high + 2 * slack_, n, 0, best);
        if (!(bins.scale[number] > 0)) continue;
        double below = 0;
        double above = n;
        for (int i = 1; i < bins.count; ++i) {
            below += bins.starts[number][static_cast<std::size_t>(i - 1)];
            above -= bins.ends[number][static_cast<std::size_t>(i - 1)];
            consider(axis, low + i / bins.scale[number], below, above, best);
        }
    }
}
