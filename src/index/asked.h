// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray has asked of late. Items stand in several leaves, and to ask some of them again takes
// longer than to remember. Used by the world and by composites, for each ray anew.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace candelabra {

class Asked {
public:
    /// Whether the item is among the last ones that this was called for.
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
    std::array<std::uint32_t, 16> items_;  ///< of which the first count_ are in use
    std::size_t count_ = 0, next_ = 0;
};

}  // namespace candelabra
