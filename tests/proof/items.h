// SPDX-License-Identifier: GPL-3.0-or-later
// Random legal items of the language, from its vocabulary: whatever kind, field or range the
// vocabulary has is drawn without a line here. Kinds whose values depend on each other (the faces
// of a mesh) have their values in a table.
#pragma once

#include "proof/dice.h"
#include "proof/element.h"
#include "vocabulary/item_info.h"

#include <span>

namespace candelabra::proof {

/// The items of a group of the catalogue: "Shapes".
std::span<const ItemInfo* const> items_of(std::string_view group);
/// One of them.
const ItemInfo& item_of(std::string_view group, std::string_view name);

/// The item's values without a word.
std::string drawn_values(const ItemInfo&, Dice&);

/// Words of the item with their values, each with a probability. Of words that exclude each other
/// there is one at most.
std::vector<Element> drawn_words(const ItemInfo&, Dice&, double probability);

/// The whole item.
Element drawn(const ItemInfo&, Dice&, double probability = 0.2);

/// A random colour, dark to white. `clear`: it may be transparent.
std::string drawn_colour(Dice&, bool clear = false);

/// A map of two or three colours.
Element drawn_map(Dice&, bool clear = false);

}  // namespace candelabra::proof
