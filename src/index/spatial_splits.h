// SPDX-License-Identifier: GPL-3.0-or-later
// Long items that lie aslant fill little of their boxes, so rays meet many boxes for nothing. Such
// items are built into the hierarchy in pieces, whose boxes are smaller (after Karras and Aila,
// "Fast Parallel Construction of High-Quality Bounding Volume Hierarchies", 2013). Called by the
// builder of the hierarchy; a pure function of the items.
#pragma once

#include "index/split.h"

#include <functional>
#include <vector>

namespace candelabra {

/// Bounds of the part of an item in a cell; empty when it does not pass through it. For items that
/// fill their boxes the cell itself will do.
using ItemPart = std::function<Box(std::uint32_t item, const Box& cell)>;

/// The items within a box, in pieces where that is worth the while; nothing when it is nowhere, as
/// with items that are few, small or far apart. Pieces are made larger by `slack` on each side, but
/// not beyond the box of their item.
std::vector<PrimRef> pieces_of(std::span<const PrimRef>, const Box& around, const ItemPart&,
                               double slack);

}  // namespace candelabra
