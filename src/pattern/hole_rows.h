// SPDX-License-Identifier: GPL-3.0-or-later
// Accelerates sequences of many black holes: their balls are kept in rows of eight. A point is
// inside few of a thousand holes, and the others are skipped a row at a time. Made by the creator
// of a PatternUse with many steps; used by its place().
#pragma once

#include "pattern/warp.h"

#include <array>

namespace candelabra {

class HoleRows {
public:
    /// Minimum number of black holes; fewer are tested one by one.
    static constexpr std::size_t least = 16;

    explicit HoleRows(std::span<const WarpStep>);

    /// Equals warped() for the steps that this was made of, with further steps appended.
    Vec3 warped(std::span<const WarpStep>, Vec3 point) const;

private:
    /// Of the first `end` steps, drops the last ones that surely leave the point in place; returns
    /// the number of those that remain.
    std::size_t left(const Vec3& point, std::size_t end) const;

    static constexpr std::size_t width = 8;
    /// In single precision, with the radii enlarged so that rounding cannot skip a hole. Steps
    /// other than single black holes have an infinite radius.
    struct Row {
        std::array<float, width> x{}, y{}, z{}, radius{};
    };
    std::vector<Row> rows_;
    std::size_t count_;
};

/// Returns null if there are too few black holes to benefit.
Handle<HoleRows> hole_rows(std::span<const WarpStep>);

}  // namespace candelabra
