// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/weighted_places.h"

#include <algorithm>
#include <bit>

namespace candelabra {

namespace {

/// Approximate total number of places, which suits the random numbers.
constexpr double all_places = 0x1p48;
constexpr int guide_bits = 12;

}  // namespace

WeightedPlaces::WeightedPlaces(std::span<const double> weights) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    std::uint64_t end = 0;
    ends_.reserve(weights.size());
    for (const double weight : weights) {
        if (weight > 0) end += 1 + static_cast<std::uint64_t>(weight / sum * all_places);
        ends_.push_back(end);
    }
    guide_shift_ = std::max(0, static_cast<int>(std::bit_width(end)) - guide_bits);
    std::uint32_t element = 0;
    for (std::uint64_t part = 0; part << guide_shift_ < end; ++part) {
        while (ends_[element] <= part << guide_shift_) ++element;
        guide_.push_back(element);
    }
}

std::uint32_t WeightedPlaces::at(std::uint64_t place) const {
    const std::size_t part = place >> guide_shift_;
    const auto first = ends_.begin() + guide_[part];
    const auto last = part + 1 < guide_.size() ? ends_.begin() + guide_[part + 1] + 1 : ends_.end();
    return static_cast<std::uint32_t>(std::upper_bound(first, last, place) - ends_.begin());
}

std::uint32_t WeightedPlaces::at_share(double u) const {
    const auto place = static_cast<std::uint64_t>(u * static_cast<double>(total()));
    return at(std::min(place, total() - 1));
}

std::size_t WeightedPlaces::memory_bytes() const {
    return ends_.capacity() * sizeof(std::uint64_t) + guide_.capacity() * sizeof(std::uint32_t);
}

}  // namespace candelabra
