// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the trees that rays traverse. Used by the world, composites and shapes of many parts.
#pragma once

#include "index/spatial_splits.h"

namespace candelabra {

/// Returns the bounds of an item.
using ItemBox = std::function<Box(std::uint32_t item)>;

/// Items with an empty box are left out, and items whose box is not finite() are visited by every
/// ray. The number of items must be below WideTree::item_limit. With cells, items may be in several
/// leaves. With boxes, only long diagonal items may, if their parts are known. threads = 0 means
/// one per core; the tree is the same for any number.
///
/// Boxes are enlarged by 2^-46 of the largest coordinate. This is some thirty times the rounding
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
