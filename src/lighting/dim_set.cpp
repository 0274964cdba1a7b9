// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include <algorithm>
#include <bit>

namespace {

/// Sum of the weights, nearly: fits the random numbers, and leaves each luminaire of millions thousands of places.
constexpr double total_places = 0x1p48;
constexpr int guide_bits = 12;
/// Share of the weight that is the same for all. The paper gives all of it evenly; luminaires are rarely that alike: on a
/// sphereflake (luminaires of four sizes, equally bright in sum) the variance is 15 times greater then.
constexpr double even_share = 0.1;

}  // namespace

LightWeights::LightWeights(std::span<const double> intensities) {
    double sum = 0;
    for (const double intensity : intensities) sum += intensity;
    const double even = 1 / static_cast<double>(intensities.size());
    std::uint64_t end = 0;
    ends_.reserve(intensities.size());
    for (const double intensity : intensities) {
        const double share = sum > 0 ? even_share * even + (1 - even_share) * (intensity / sum) : even;
        end += 1 + static_cast<std::uint64_t>(share * total_places);
        ends_.push_back(end);
    }
    guide_shift_ = std::max(0, static_cast<int>(std::bit_width(end)) - guide_bits);
    LightIndex light = 0;
    for (std::uint64_t part = 0; part << guide_shift_ < end; ++part) {
        while (ends_[light] <= part << guide_shift_) ++light;
        guide_.push_back(light);
    }
}

LightIndex LightWeights::at(std::uint64_t place) const {
    const std::size_t part = place >> guide_shift_;
    const auto first = ends_.begin() + guide_[part];
    const auto last = part + 1 < guide_.size() ? ends_.begin() + guide_[part + 1] + 1 : ends_.end();
    return static_cast<LightIndex>(std::upper_bound(first, last, place) - ends_.begin());
}

std::size_t LightWeights::memory_bytes() const {
    return ends_.capacity() * sizeof(std::uint64_t) + guide_.capacity() * sizeof(LightIndex);
}

std::uint64_t DimSet::total() const {
    if (bright_.empty()) return weights_.total();
    const LightIndex last = bright_.back();
    return places_.back() + (weights_.total() - weights_.before(last) - weights_.weight(last));
}

LightIndex DimSet::at(std::uint64_t place) const {
    const auto passed = std::upper_bound(places_.begin(), places_.end(), place) - places_.begin();
    if (passed == 0) return weights_.at(place);
    const LightIndex last = bright_[static_cast<std::size_t>(passed - 1)];
    const std::uint64_t bright_weight = weights_.before(last) + weights_.weight(last) - places_[static_cast<std::size_t>(passed - 1)];
    return weights_.at(place + bright_weight);
}

std::vector<std::uint64_t> dim_places(const LightWeights& weights, std::span<const LightIndex> bright) {
    std::vector<std::uint64_t> result;
    result.reserve(bright.size());
    std::uint64_t taken = 0;
    for (const LightIndex light : bright) {
        result.push_back(weights.before(light) - taken);
        taken += weights.weight(light);
    }
    return result;
}
