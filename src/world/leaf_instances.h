// SPDX-License-Identifier: GPL-3.0-or-later
// The instances in a leaf of the tree that a ray may meet. A ray among many instances waits for
// memory most of the time: it reads the place of each, and finds few of them in the cache. So all
// are fetched before the first is asked.
#pragma once

#include "world/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace candelabra {

class LeafInstances {
public:
    explicit LeafInstances(const Geometry& geometry)
        : geometry_(geometry), begin_(geometry.instances_begin()) {}

    /// Takes the item if it is an instance.
    bool take(std::uint32_t item) {
        if (item < begin_) return false;
        __builtin_prefetch(&geometry_.instances[item - begin_]);
        items_[count_++] = item;
        return true;
    }

    /// Calls ask(item) -> bool for each taken item, and forgets them. Stops and returns true when
    /// ask does.
    template <class Ask>
    bool any_of(Ask ask) {
        for (std::size_t i = 0; i < count_; ++i) {
            const auto* const place = reinterpret_cast<const std::byte*>(
                geometry_.instances[items_[i] - begin_].place.get());
            for (std::size_t line = 0; line < sizeof(Transform); line += cache_line)
                __builtin_prefetch(place + line);
        }
        const std::size_t count = count_;
        count_ = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (ask(items_[i])) return true;
        return false;
    }

private:
    static constexpr std::size_t cache_line = 64;

    const Geometry& geometry_;
    std::uint32_t begin_;
    std::array<std::uint32_t, TreeNode::width> items_;  ///< the first count_ are in use
    std::size_t count_ = 0;
};

}  // namespace candelabra
