// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/dim_set.h"

#include <algorithm>
#include <bit>

namespace candelabra {

namespace {

/// Approximate total number of places, which suits the random numbers.
constexpr double all_places = 0x1p48;
constexpr int guide_bits = 12;

}  // namespace

LightPlaces::LightPlaces(std::span<const double> intensities) {
    double sum = 0;
    for (const double intensity : intensities) sum += intensity;
    std::uint64_t end = 0;
    ends_.reserve(intensities.size());
    for (const double intensity : intensities) {
        if (intensity > 0) end += 1 + static_cast<std::uint64_t>(intensity / sum * all_places);
        ends_.push_back(end);
    }
    guide_shift_ = std::max(0, static_cast<int>(std::bit_width(end)) - guide_bits);
    LightIndex light = 0;
    for (std::uint64_t part = 0; part << guide_shift_ < end; ++part) {
        while (ends_[light] <= part << guide_shift_) ++light;
        guide_.push_back(light);
    }
}

LightIndex LightPlaces::at(std::uint64_t place) const {
    const std::size_t part = place >> guide_shift_;
    const auto first = ends_.begin() + guide_[part];
    const auto last = part + 1 < guide_.size() ? ends_.begin() + guide_[part + 1] + 1 : ends_.end();
    return static_cast<LightIndex>(std::upper_bound(first, last, place) - ends_.begin());
}

std::size_t LightPlaces::memory_bytes() const {
    return ends_.capacity() * sizeof(std::uint64_t) + guide_.capacity() * sizeof(LightIndex);
}

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

std::vector<std::uint64_t> dim_places_before(const LightPlaces& places,
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
