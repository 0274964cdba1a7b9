// SPDX-License-Identifier: GPL-3.0-or-later
// Long diagonal items fill little of their boxes, so rays meet many boxes in vain. Such items are
// built into the hierarchy in pieces with smaller boxes (after Karras and Aila, "Fast Parallel
// Construction of High-Quality Bounding Volume Hierarchies", 2013). Used by the builder of the
// hierarchy; a pure function of the items.
#pragma once

#include "index/split.h"

#include <functional>
#include <vector>

namespace candelabra {

/// Returns the bounds of the part of an item in a cell; empty if the item does not pass through it.
/// For items that fill their boxes, it may return the cell itself.
using ItemPart = std::function<Box(std::uint32_t item, const Box& cell)>;

/// Returns the items within a box, in pieces where this reduces the cost. Returns nothing if it
/// never does, as for few, small or distant items. Pieces are enlarged by `slack` on each side, but
/// not beyond the box of their item.
std::vector<PrimRef> pieces_of(std::span<const PrimRef>, const Box& around, const ItemPart&,
                               double slack);

}  // namespace candelabra
