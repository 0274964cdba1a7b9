// SPDX-License-Identifier: GPL-3.0-or-later
// The index that a random number selects in proportion to weights, such as those of parts of a sky,
// of a screen or of a mesh: by their prefix sums or, where they are used once, by the weights.
#pragma once

#include "base/random.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace candelabra {

/// An index, and the position of the number within its weight, in [0, 1).
struct DrawnShare {
    std::size_t index;
    double within;
};

/// Precondition: the last sum is above 0; u is in [0, 1]. Never selects an index of weight 0.
template <class Sum>
DrawnShare drawn_share(std::span<const Sum> sums, double u) {
    const double at = u * static_cast<double>(sums.back());
    auto above = std::ranges::upper_bound(sums, static_cast<Sum>(at));
    if (above == sums.end()) --above;
    while (above != sums.begin() && above[-1] == above[0]) --above;
    const double before = above == sums.begin() ? 0.0 : static_cast<double>(above[-1]);
    const double within = (at - before) / (static_cast<double>(*above) - before);
    return {static_cast<std::size_t>(above - sums.begin()), std::clamp(within, 0.0, below_1)};
}

template <class Sum>
double weight_of(std::span<const Sum> sums, std::size_t index) {
    const double before = index > 0 ? static_cast<double>(sums[index - 1]) : 0.0;
    return static_cast<double>(sums[index]) - before;
}

/// Fraction of the total weight at an index. Precondition: the last sum is above 0.
template <class Sum>
double share_of(std::span<const Sum> sums, std::size_t index) {
    return weight_of(sums, index) / static_cast<double>(sums.back());
}

/// An index where a running sum may pass a target.
struct ChosenWeight {
    std::size_t index = 0;
    double weight = 0;    ///< at the index; 0: no weight is above 0
    bool passed = false;  ///< false: rounding carried the target past the end, and this is the last
                          ///< index whose weight is above 0
};

/// Returns the index at which the running sum of the weights passes the target, from which those
/// before are subtracted. Never one whose weight is 0.
template <class Weight>
ChosenWeight choose(std::span<const Weight> weights, double& target) {
    ChosenWeight last;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double weight = weights[i];
        if (!(weight > 0)) continue;
        last = {i, weight, target < weight};
        if (last.passed) break;
        target -= weight;
    }
    return last;
}

}  // namespace candelabra
