// SPDX-License-Identifier: GPL-3.0-or-later
// Where to divide a cell of the kd-tree: the plane of least cost by the surface area heuristic
// (MacDonald and Booth, "Heuristics for Ray Tracing Using Space Subdivision", 1990).
// Called by the builder in kdtree.cpp; a pure function of the fragments and the cell.
#pragma once

#include "base/box.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// The part of one item that lies in the cell.
struct Fragment {
    Box box;
    std::uint32_t item = 0;
};

/// What a step costs, in any one unit. See KdTreeSettings for the meaning and the defaults.
struct SplitCosts {
    double traversal = 0;
    double intersection = 0;
    double empty_bonus = 0;
    double group = 1;
};

struct Split {
    int axis = -1;        ///< -1: not dividing is cheapest
    double position = 0;  ///< strictly inside the cell
    double cost = std::numeric_limits<double>::infinity();

    bool found() const { return axis >= 0; }
};

/// A box belongs to a side of a plane when it comes within `slack` of it.
inline bool reaches_below(double low, double plane, double slack) { return low <= plane + slack; }
inline bool reaches_above(double high, double plane, double slack) { return high >= plane - slack; }

/// Finds planes; holds only scratch memory, so that one of it serves many cells.
class SplitFinder {
public:
    SplitFinder(const SplitCosts& costs, double slack) : costs_(costs), slack_(slack) {}

    Split find(std::span<const Fragment> fragments, const Box& cell);

private:
    struct Axis;

    void sweep(std::span<const Fragment>, const Axis&, Split& best);
    void bin(std::span<const Fragment>, const std::array<Axis, 3>&, Split& best) const;
    void consider(const Axis&, double position, double below, double above, Split& best) const;

    SplitCosts costs_;
    double slack_;
    std::vector<double> lows_;
    std::vector<double> highs_;
};
