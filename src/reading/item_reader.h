// SPDX-License-Identifier: GPL-3.0-or-later
// Groups the flat elements of a block by the vocabulary of its item: positional values in order,
// words followed by values, switches, lists. All diagnostics about wrong, missing and repeated
// values are made here from the vocabulary. Called by the readers of objects, textures, cameras,
// lights and settings.
#pragma once

#include "reading/convert.h"

#include <cstdint>
#include <optional>

namespace candelabra {

class ItemReader {
public:
    /// All arguments outlive the reader. The item has the type that the vocabulary describes.
    ItemReader(OpenBlock&, const ItemInfo&, void* item);

    bool waiting() const { return word_ >= 0 || switch_ >= 0 || loose_part_; }
    bool wants() const { return word_ >= 0 || loose_part_ || required_missing(); }
    bool take(const Element&);
    void finish();
    void add_words(WordList&) const;

    /// Starts to read another item, which may have another type. `word` is the place of the item's
    /// own word, if it has one inside the block. Precondition: not waiting().
    void rebind(const ItemInfo&, void* item, Span word = {});
    /// Marks all fields as optional: the item is a copy of a complete one.
    void complete() { next_ = positional_; }
    /// Allows words to come repeatedly, each time with an effect of its own.
    void repeatable() { repeatable_ = true; }
    /// Sets the value that the word has when no number follows it.
    void alone(std::string_view word, double value);

    /// The field whose word was read last and still lacks its value; empty: none.
    std::string_view expected() const {
        return word_ >= 0 ? info_->fields[static_cast<std::size_t>(word_)].name
                          : std::string_view();
    }
    /// The field that the last take() stored, or -1.
    int stored() const { return stored_; }
    /// Number of positional values read so far.
    int positional_given() const { return next_; }
    /// Whether the word belongs to the vocabulary.
    bool knows(NameId word) const { return find(word) >= 0; }
    /// Whether the block has given the field.
    bool given(std::string_view field) const;

private:
    bool required_missing() const;
    bool follows(int field) const;
    bool take_value(const Element&);
    bool take_word(const Element&);
    bool take_block(const Element&);
    bool take_list(const Element&);
    void take_counted(const Element&);
    void take_loose(const Element&);
    void take_count(const Element&);
    void take_entry(const Element&);
    bool counting() const { return entries_left_ >= 0; }
    void begin_entries(int count);
    void store_and_go_on(int field, const Element&);
    void store(int field, const Element&);
    void set(int field, const FieldValue&, Span);
    void end_switch() { switch_ = -1; }
    int find(NameId word) const;
    int find(std::string_view word) const;
    void begin(int field, Span word);
    void missing_value();
    /// Checks the value and reports errors. If any sign is allowed, first takes the absolute value.
    bool in_range(const ItemInfo&, const FieldInfo&, const Slot&, FieldValue&, Span);
    std::string of_block(int field) const;
    std::string help(int field) const;
    void read_list(int field, const Element&);

    OpenBlock& block_;
    const ItemInfo* info_;
    void* item_;
    int positional_ = 0;  ///< number of fields without a word, which come first
    int next_ = 0;        ///< positional field that takes the next value
    int word_ = -1;       ///< field whose word still lacks its value, or -1
    int switch_ = -1;     ///< last switch, or optional field that may follow the last value; or -1
    int stored_ = -1;
    int alone_ = -1;
    double alone_value_ = 0;
    Span word_span_;
    Span item_span_ = {};  ///< place of the item's own word, if it has one
    std::uint64_t given_ = 0;
    FieldValue entries_;     ///< entries of the counted field that have been read
    int entries_left_ = -1;  ///< -1: none are expected now
    int entry_count_ = 0;
    void* loose_part_ = nullptr;  ///< part whose values are expected now
    int loose_next_ = 0;
    std::optional<Vec3> centre_;  ///< centre of a ball whose radius comes next
    bool repeatable_ = false;
};

}  // namespace candelabra
