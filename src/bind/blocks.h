// SPDX-License-Identifier: GPL-3.0-or-later
// The table of blocks (reading/block_table.h), which also states what completion offers in a block
// (bind/block_words.h).
//
// A new block touches four places:
//   1. its row in blocks.cpp, which names its reader: read_item() (reading/item_block.h), or a
//      reader of its own if it has more than the fields of an item;
//   2. the scene (scene/scene.h) or the item around it, which holds the result;
//   3. its text in scene/dump.cpp or dump_texture.cpp;
//   4. the catalogue (scene/catalogue.cpp), the source of help, manual and editor support; a block
//      that is no item has its text in vocabulary/glossary.cpp instead.
// A block that stands in another one is also named in the reader of that one.
// Messages call its values by the name in its vocabulary. tests/bind/blocks_test.cpp checks each
// row.
#pragma once

#include "reading/block_table.h"

namespace candelabra {

const BlockTable& block_table();

}  // namespace candelabra
