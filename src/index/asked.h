// SPDX-License-Identifier: GPL-3.0-or-later
// The items that a ray has tested recently. Items may be in several leaves, and testing one again
// takes longer than remembering it. Used by the world and by composites, anew for each ray.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace candelabra {

class Asked {
public:
    /// Whether the item is among the last ones for which this was called.
    bool before(std::uint32_t item) {
        bool found = false;
        for (std::size_t i = 0; i < count_; ++i) found |= items_[i] == item;
        if (found) return true;
        if (count_ < items_.size()) ++count_;
        items_[next_] = item;
        next_ = (next_ + 1) % items_.size();
        return false;
    }

private:
    std::array<std::uint32_t, 16> items_;  ///< the first count_ are in use
    std::size_t count_ = 0, next_ = 0;
};

}  // namespace candelabra
