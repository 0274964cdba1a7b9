// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of many black holes in rows, eight to a row: of a thousand holes a point is in few, and
// those that leave it where it is are passed over together. Made by whoever makes a PatternUse of
// many steps, asked by its place().
#pragma once

#include "pattern/warp.h"

#include <array>

namespace candelabra {

class HoleRows {
public:
    /// Fewer black holes are asked one by one.
    static constexpr std::size_t least = 16;

    explicit HoleRows(std::span<const WarpStep>);

    /// warped(), for the steps that this is made of, and more of them at the end.
    Vec3 warped(std::span<const WarpStep>, Vec3 point) const;

private:
    /// The number of steps, from the first on, that are left when the last ones that surely leave
    /// the point where it is are taken away; `end` is how many there were.
    std::size_t left(const Vec3& point, std::size_t end) const;

    static constexpr std::size_t width = 8;
    /// Single precision, and radii so much larger that rounding passes over no hole. A step that is
    /// no such hole has a radius without end.
    struct Row {
        std::array<float, width> x{}, y{}, z{}, radius{};
    };
    std::vector<Row> rows_;
    std::size_t count_;
};

/// Null where there are too few black holes to gain by it.
Handle<HoleRows> hole_rows(std::span<const WarpStep>);

}  // namespace candelabra
