// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include <algorithm>

namespace candelabra {

LightIndex DimSet::nth(std::uint64_t n) const {
    // The j-th luminaire of the list has bright[j] - j dim ones before it, which never falls with
    // j.
    std::size_t passed = 0, behind = bright_.size();
    while (passed < behind) {
        const std::size_t j = (passed + behind) / 2;
        if (bright_[j] - j <= n)
            passed = j + 1;
        else
            behind = j;
    }
    return static_cast<LightIndex>(n + passed);
}

std::uint64_t DimSet::places() const {
    if (bright_.empty()) return places_.total();
    return dim_before_.back() + (places_.total() - places_.end(bright_.back()));
}

LightIndex DimSet::at(std::uint64_t place) const {
    const auto passed = static_cast<std::size_t>(std::ranges::upper_bound(dim_before_, place) -
                                                 dim_before_.begin());
    if (passed == 0) return places_.at(place);
    return places_.at(place + (places_.end(bright_[passed - 1]) - dim_before_[passed - 1]));
}

std::vector<std::uint64_t> dim_places_before(const WeightedIndex& places,
                                             std::span<const LightIndex> bright) {
    std::vector<std::uint64_t> result;
    result.reserve(bright.size());
    std::uint64_t taken = 0;
    for (const LightIndex light : bright) {
        result.push_back(places.before(light) - taken);
        taken += places.of(light);
    }
    return result;
}

}  // namespace candelabra
