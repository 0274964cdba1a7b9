// SPDX-License-Identifier: GPL-3.0-or-later
// The form of the table of blocks: each word of the language that is not a field of an item, with
// the blocks that take it, its form, and its readers. The table answers which words make objects,
// which take braces, and which block a misplaced word belongs in. bind/blocks.cpp has its rows, and
// each Binder refers to it: so readers reach those of other blocks, which come after them.
#pragma once

#include "interpret/evaluator.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace candelabra {

struct Binder;
class SceneContent;  // of bind/, which alone reads scenes

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

class BlockTable {
public:
    /// Reads a block that makes an object, as a part (objects/objects.h).
    using ReadObject = ObjectHandle (*)(Binder&, const Element&);

    /// The rows outlive the table. All shapes share the row `shape`.
    BlockTable(std::span<const BlockRow> rows, const BlockRow& shape, ReadObject);

    /// All rows except that of shapes.
    std::span<const BlockRow> rows() const { return rows_; }
    /// The row of a reserved word, or null if it has none.
    const BlockRow* row(NameId word) const {
        const auto number = static_cast<std::size_t>(word);
        return number < by_number_.size() ? by_number_[number] : nullptr;
    }
    /// The row of a word, which need not be reserved; null if it has none. Not that of shapes.
    const BlockRow* row(std::string_view word) const;
    /// The row of a word of a scene that only this language has, such as `meter`: it has no number
    /// of its own, so that scenes may declare it. Null if there is none.
    const BlockRow* scene_row(std::string_view word) const;

    /// Whether a block with this word makes one object of several.
    bool combines_objects(NameId word) const {
        const BlockRow* found = row(word);
        return found && found->form == BlockRow::Form::combination;
    }
    /// Whether a block with this word makes an object.
    bool makes_object(NameId word) const {
        const BlockRow* found = row(word);
        return found && found->makes_object();
    }
    /// Whether the word needs braces.
    bool takes_braces(NameId word) const {
        const BlockRow* found = row(word);
        return found && found->form != BlockRow::Form::word;
    }
    /// Returns the blocks that the word belongs in, the most usual first; empty for a word that
    /// only a scene takes, and for words that are unknown.
    std::vector<std::string_view> homes(std::string_view word) const;
    /// Whether this language knows the word in blocks. Other reserved words are POV-Ray's and not
    /// available.
    bool knows(std::string_view word) const;

    const ReadObject read_object;

private:
    std::span<const BlockRow> rows_;
    std::vector<const BlockRow*> by_number_;
};

/// The homes of a row that messages name.
std::string_view main_homes(std::string_view homes);

}  // namespace candelabra
