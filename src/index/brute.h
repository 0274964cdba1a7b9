// SPDX-License-Identifier: GPL-3.0-or-later
// The trivial index: every ray visits every item. Tests and benchmarks compare the hierarchy
// against it; it can replace the hierarchy wherever the index is a template parameter.
#pragma once

#include "base/ray.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace candelabra {

class BruteForce {
public:
    BruteForce() = default;
    explicit BruteForce(std::size_t count) : items_(count) {
        std::iota(items_.begin(), items_.end(), 0u);
    }

    /// As WideTree::traverse, with one leaf for all items.
    template <class Visit>
    bool traverse(const Ray&, Interval range, Visit&& visit) const {
        return !items_.empty() && visit(std::span<const std::uint32_t>(items_), range);
    }

private:
    std::vector<std::uint32_t> items_;
};

}  // namespace candelabra
