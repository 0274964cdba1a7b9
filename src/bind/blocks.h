// SPDX-License-Identifier: GPL-3.0-or-later
// The table of blocks (reading/block_table.h), which also states what completion offers in a block
// (bind/block_words.h).
//
// A new block touches five places:
//   1. its reader, and the reader of the block around it if it stands in another one;
//   2. its row in blocks.cpp;
//   3. the scene (scene/scene.h) or the item around it, which holds the result;
//   4. its text in scene/dump.cpp or dump_texture.cpp;
//   5. the catalogue (scene/catalogue.cpp), the source of help, manual and editor support; a block
//      that is no item has its text in vocabulary/glossary.cpp instead.
// Messages call its values by the name in its vocabulary. tests/bind/blocks_test.cpp checks each
// row.
#pragma once

#include "reading/block_table.h"

namespace candelabra {

const BlockTable& block_table();

}  // namespace candelabra
