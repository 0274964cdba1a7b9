// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes that can be joined quickly: split searches keep one for each bin and join millions.
#pragma once

#include "base/box.h"
#include "base/lanes.h"

#include <cstring>

namespace candelabra {

/// A box with negated lower ends, so that joining takes the maximum of all numbers: vectors of four
/// lanes and of two, in the order in which boxes are stored.
struct Extent {
    using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
    using Two [[gnu::vector_size(2 * sizeof(double))]] = double;

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Four four = Four{} - infinity;  ///< the lower ends, and the upper end of x
    Two two = Two{} - infinity;     ///< the upper ends of y and z

    [[gnu::always_inline]] static Extent of(const Box& box) {
        constexpr Four signs = {-1, -1, -1, 1};
        Extent extent;
        static_assert(sizeof box == sizeof extent.four + sizeof extent.two);
        std::memcpy(&extent.four, &box, sizeof extent.four);
        std::memcpy(&extent.two, &box.high.y, sizeof extent.two);
        extent.four *= signs;
        return extent;
    }
    [[gnu::always_inline]] void join(const Extent& other) {
        four = greatest_of(other.four, four);
        two = greatest_of(other.two, two);
    }
    Box box() const { return {{-four[0], -four[1], -four[2]}, {four[3], two[0], two[1]}}; }
};

}  // namespace candelabra
