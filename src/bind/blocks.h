// SPDX-License-Identifier: GPL-3.0-or-later
// The table of blocks: each word of the language that is not a field of an item, with the blocks
// that take it, its form, and its readers. The table answers which words make objects, which take
// braces, which words a scene, #declare and #default take, which block a misplaced word belongs in,
// and what completion offers in a block (bind/block_words.h).
//
// A new block touches five places:
//   1. its reader, and the reader of the block around it if it stands in another one;
//   2. its row here, in blocks.cpp;
//   3. the scene (scene/scene.h) or the item around it, which holds the result;
//   4. its text in scene/dump.cpp or dump_texture.cpp;
//   5. the catalogue (scene/catalogue.cpp), the source of help, manual and editor support; a block
//      that is no item has its text in vocabulary/glossary.cpp instead.
// Messages call its values by the name in its vocabulary. tests/bind/blocks_test.cpp checks each
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
        word,         ///< may stand without braces
        block,        ///< needs braces
        object,       ///< needs braces and makes an object
        combination,  ///< needs braces and makes one object of several
    };

    std::string_view word;
    /// Space-separated names of the blocks that take it, which messages name; behind `|` those that
    /// take it beside. `object` stands for every block that makes an object. Empty: only a scene.
    std::string_view homes = {};
    Form form = Form::word;
    /// Reads a block in a scene. Null: the word may not stand in a scene.
    void (*in_scene)(SceneContent&, const Element&) = nullptr;
    /// Reads the value for #declare; a broken value after a diagnostic. Null: it is not a value.
    Value (*as_value)(Binder&, const Element&) = nullptr;
    /// Reads the block in #default. Null: not allowed there.
    void (*as_default)(Binder&, const Element&) = nullptr;
    /// Another block whose words this one takes, or its entries in brackets; `objects`: the words
    /// that make objects.
    std::string_view like = {};

    bool makes_object() const { return form == Form::object || form == Form::combination; }
};

/// All rows except that of shapes.
std::span<const BlockRow> block_rows();

/// The row of a reserved word, or null if it has none. All shapes share one row.
const BlockRow* block_row(NameId word);

/// The row of a word of a scene that only this language has, such as `meter`: it has no number of
/// its own, so that scenes may declare it. Null if there is none.
const BlockRow* scene_row(std::string_view word);

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

/// Whether the word needs braces.
inline bool takes_braces(NameId word) {
    const BlockRow* row = block_row(word);
    return row && row->form != BlockRow::Form::word;
}

}  // namespace candelabra
