// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the trees that rays walk. Called by the world, composites and shapes of many parts.
#pragma once

#include "index/spatial_splits.h"

namespace candelabra {

/// Bounds of an item.
using ItemBox = std::function<Box(std::uint32_t item)>;

/// Items with an empty box are left out, and those whose box is not finite() are visited by every
/// ray; there must be fewer than WideTree::item_limit.
/// Divided into cells, items may stand in several leaves; divided into boxes, those that are long
/// and lie aslant may, where their parts are known, and all others stand in one. threads = 0 means
/// one per core; the tree is the same for any number.
///
/// Boxes are made larger by 2^-46 of the largest coordinate. This is some thirty times the rounding
/// error of a plane's ray parameter, so a hit within that distance of its item is found for all
/// origins up to thirty times as far away as the items.
WideTree build_tree(std::uint32_t items, const ItemBox&, const ItemPart&, const TreeSettings& = {},
                    int threads = 0);
inline WideTree build_tree(std::span<const Box> boxes, const TreeSettings& settings = {},
                           int threads = 0) {
    return build_tree(
        static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t item) { return boxes[item]; },
        {}, settings, threads);
}

}  // namespace candelabra
