// SPDX-License-Identifier: GPL-3.0-or-later
// An index by weight that counts exactly: weights become integers, so rounding cannot lose an
// element. For draws in proportion to weights of any range among many elements, and in parts of
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// All elements laid end to end. Each takes a number of slots in proportion to its weight: at
/// least one, unless its weight is 0.
class WeightedIndex {
public:
    WeightedIndex() = default;
    /// Precondition: no weight is below 0.
    explicit WeightedIndex(std::span<const double> weights);

    std::size_t size() const { return ends_.size(); }
    std::uint64_t total() const { return ends_.empty() ? 0 : ends_.back(); }
    std::uint64_t before(std::uint32_t i) const { return i == 0 ? 0 : ends_[i - 1]; }
    std::uint64_t end(std::uint32_t i) const { return ends_[i]; }
    /// Has the end of an element fetched from memory.
    void fetch(std::uint32_t i) const { __builtin_prefetch(&ends_[i]); }
    std::uint64_t of(std::uint32_t i) const { return end(i) - before(i); }
    /// Returns the element that takes the slot. Precondition: slot < total().
    std::uint32_t at(std::uint64_t slot) const;
    /// Returns the element that takes that fraction of the slots, in [0, 1): one drawn by its
    /// weight for a random number. Precondition: total() is above 0.
    std::uint32_t at_share(double u) const;
    /// Where that fraction lies within the slots of its element i: a number in [0, 1) that is left
    /// of the random one.
    double within(std::uint32_t i, double u) const;
    /// Fraction of the slots that the element takes: its probability.
    double share_of(std::uint32_t i) const {
        return static_cast<double>(of(i)) / static_cast<double>(total());
    }
    std::size_t memory_bytes() const;

private:
    std::vector<std::uint64_t> ends_;
    std::vector<std::uint32_t> buckets_;  ///< first element of each of equal parts of the slots
    int bucket_shift_ = 0;
};

}  // namespace candelabra
