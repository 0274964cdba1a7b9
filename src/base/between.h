// SPDX-License-Identifier: GPL-3.0-or-later
// The place of a value in a rising list, for tables whose entries are interpolated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace candelabra {

/// A place between two neighbours of a list.
struct Between {
    std::size_t low, high;  ///< numbers of the neighbours; the same one in a list of one
    double fraction;        ///< of the way from the lower one, 0 to 1

    /// The value there of a list that belongs to it, exact at its entries.
    double of(std::span<const double> values) const {
        return (1 - fraction) * values[low] + fraction * values[high];
    }
};

/// The place of a value; beyond the ends of the list it is at them. Precondition: the list rises
/// strictly and is not empty.
inline Between place_between(std::span<const double> list, double value) {
    if (list.size() == 1) return {0, 0, 0};
    const auto next = std::upper_bound(list.begin() + 1, list.end() - 1, value);
    const auto high = static_cast<std::size_t>(next - list.begin());
    const double fraction = (value - list[high - 1]) / (list[high] - list[high - 1]);
    return {high - 1, high, std::clamp(fraction, 0.0, 1.0)};
}

}  // namespace candelabra
