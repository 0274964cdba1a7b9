// SPDX-License-Identifier: GPL-3.0-or-later
// The words that stand in each block, and the blocks that a word stands in: by the table of blocks
// (bind/blocks.h) and the vocabularies of the items. Messages about misplaced words and completion
// are made from it.
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

/// Returns the blocks that the word belongs in, the most usual first; empty for a word that only a
/// scene takes, and for words that are unknown.
std::vector<std::string_view> homes(std::string_view word);

}  // namespace candelabra
