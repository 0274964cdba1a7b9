// SPDX-License-Identifier: GPL-3.0-or-later
// The table of blocks: each word that has a place of its own in the language beside the fields of
// items, with the blocks that it belongs in, its form, and its readers. Whoever has to know about a
// word asks here: which words make objects, which take braces, which words a scene, #declare and
// #default take, and which block a misplaced word belongs in.
//
// A new block touches five places:
//   1. its reader, and the reader of the block around it when it stands in another one;
//   2. its row here, in blocks.cpp;
//   3. the scene (scene/scene.h) or the item around it, which holds what was read;
//   4. its text in scene/dump.cpp or dump_texture.cpp;
//   5. the catalogue (scene/catalogue.cpp), from which help, manual and editors tell of it; a block
//      that is no item has its text in vocabulary/glossary.cpp instead.
// A value of it is called by the name in its vocabulary. tests/bind/blocks_test.cpp checks each
// row.
#pragma once

#include "bind/binder.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace candelabra {

class SceneContent;

struct BlockRow {
    enum class Form : std::uint8_t {
        word,         ///< may do without braces
        block,        ///< is nothing without what follows in braces
        object,       ///< such a block, which makes an object
        combination,  ///< such a block, which makes one object of several
    };

    std::string_view word;
    std::string_view homes = {};  ///< blocks that it belongs in, a blank between; empty: a scene
    Form form = Form::word;
    /// Reads one that stands in a scene. Null: a scene has none.
    void (*in_scene)(SceneContent&, const Element&) = nullptr;
    /// Reads the value that #declare stores; broken after a report. Null: it is no value.
    Value (*as_value)(Binder&, const Element&) = nullptr;
    /// Reads what #default sets. Null: nothing.
    void (*as_default)(Binder&, const Element&) = nullptr;

    bool makes_object() const { return form == Form::object || form == Form::combination; }
};

/// All rows but that of shapes.
std::span<const BlockRow> block_rows();

/// The row of a word, null when it has none. All shapes share one.
const BlockRow* block_row(NameId word);

/// Whether a block with this word makes one object of several.
inline bool combines_objects(NameId word) {
    const BlockRow* row = block_row(word);
    return row && row->form == BlockRow::Form::combination;
}

/// Whether a block with this word makes an object.
inline bool makes_object(NameId word) {
    const BlockRow* row = block_row(word);
    return row && row->makes_object();
}

/// Whether the word is nothing without what follows in braces.
inline bool takes_braces(NameId word) {
    const BlockRow* row = block_row(word);
    return row && row->form != BlockRow::Form::word;
}

}  // namespace candelabra
