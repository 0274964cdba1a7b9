// SPDX-License-Identifier: GPL-3.0-or-later
// The words that stand in each block, by the table of blocks (bind/blocks.h) and the vocabularies
// of the items. Completion is made from them.
#pragma once

#include "vocabulary/item_info.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace candelabra {

/// A word that a block takes.
struct BlockWord {
    std::string_view word;
    const ItemInfo* item = nullptr;    ///< that it names, or whose field it is; null: neither
    std::optional<std::size_t> field;  ///< of the item
    std::string_view home = {};        ///< block whose first word names the item; empty: none
};

/// Returns the words that stand in the braces of the block, or in a scene if the name is empty,
/// each once: its fields, the names of its kinds, the blocks and words inside of it, and the words
/// that it shares with others. Of a map they are those of its entries. Empty for another name.
std::vector<BlockWord> block_words(std::string_view block);

}  // namespace candelabra
