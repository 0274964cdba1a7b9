// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/weighted_index.h"

#include "base/random.h"

#include <algorithm>
#include <bit>

namespace candelabra {

namespace {

/// Approximate total number of slots, which suits the random numbers.
constexpr double all_slots = 0x1p48;
constexpr int bucket_bits = 12;

}  // namespace

WeightedIndex::WeightedIndex(std::span<const double> weights) {
    double sum = 0;
    for (const double weight : weights) sum += weight;
    std::uint64_t end = 0;
    ends_.reserve(weights.size());
    for (const double weight : weights) {
        if (weight > 0) end += 1 + static_cast<std::uint64_t>(weight / sum * all_slots);
        ends_.push_back(end);
    }
    bucket_shift_ = std::max(0, static_cast<int>(std::bit_width(end)) - bucket_bits);
    std::uint32_t element = 0;
    for (std::uint64_t part = 0; part << bucket_shift_ < end; ++part) {
        while (ends_[element] <= part << bucket_shift_) ++element;
        buckets_.push_back(element);
    }
}

std::uint32_t WeightedIndex::at(std::uint64_t slot) const {
    const std::size_t part = slot >> bucket_shift_;
    const auto first = ends_.begin() + buckets_[part];
    const auto last =
        part + 1 < buckets_.size() ? ends_.begin() + buckets_[part + 1] + 1 : ends_.end();
    return static_cast<std::uint32_t>(std::upper_bound(first, last, slot) - ends_.begin());
}

std::uint32_t WeightedIndex::at_share(double u) const {
    const auto slot = static_cast<std::uint64_t>(u * static_cast<double>(total()));
    return at(std::min(slot, total() - 1));
}

double WeightedIndex::within(std::uint32_t i, double u) const {
    const double slots = u * static_cast<double>(total()) - static_cast<double>(before(i));
    return std::clamp(slots / static_cast<double>(of(i)), 0.0, below_1);
}

std::size_t WeightedIndex::memory_bytes() const {
    return ends_.capacity() * sizeof(std::uint64_t) + buckets_.capacity() * sizeof(std::uint32_t);
}

}  // namespace candelabra
