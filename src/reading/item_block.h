// SPDX-License-Identifier: GPL-3.0-or-later
// Reads blocks that consist only of the fields of one item: nested ones, such as `irid { ... }` in
// a finish, and those of a scene, such as `meter { ... }`. Used by the readers of finishes and of
// settings, and by the table of blocks.
#pragma once

#include "reading/block.h"
#include "reading/item_reader.h"
#include "text/message.h"

#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// Fields that are accepted without effect.
struct IdleFields {
    std::span<const std::string_view> names = {};
    std::string_view why = {};
};

/// Warns once of the idle fields that the block has given.
inline void warn_of_idle_fields(OpenBlock& block, std::string_view item, const ItemReader& fields,
                                const IdleFields& idle, Span span) {
    std::string list;
    bool several = false;
    for (const std::string_view field : idle.names) {
        if (!fields.given(field)) continue;
        several = !list.empty();
        list += message(several ? ", `" : "`", field, '`');
    }
    if (list.empty()) return;
    block.report(warning(
        Fault::no_effect, span,
        message(list, " of `", item, several ? "` have" : "` has", " no effect: ", idle.why)));
}

/// Reads a block into the item. Returns false, after a diagnostic, if it was wrong. An item may
/// have a function problem(), which returns a sentence about an error in it as a whole. Messages
/// show the item's first example.
template <class T>
bool read_item(Binder& binder, const Element& element, T& item) {
    OpenBlock block(binder, T::vocabulary.name, element.word_span);
    block.item = &T::vocabulary;
    if (const auto examples = T::vocabulary.examples; !examples.empty())
        if (examples.front().starts_with(message(block.name, " {")))
            block.form = examples.front().substr(block.name.size() + 1);
    ItemReader fields(block, *block.item, &item);
    block.read(element.body, fields);
    if constexpr (requires { problem(item); })
        if (const std::string wrong = block.broken ? std::string() : problem(item); !wrong.empty())
            block.report(error(Fault::missing, block.span, wrong).with_help(block.help()));
    return !block.broken;
}

class ItemBlock : public SimpleReader {
public:
    /// All arguments outlive the reader. Sets `given`, unless null, when the block is read.
    /// `ignored`: words that are accepted in the block without effect.
    ItemBlock(OpenBlock& block, const ItemInfo& info, void* item, bool* given = nullptr,
              std::string_view ignored = {})
        : block_(block), info_(info), item_(item), given_(given), effectless_(ignored) {}

    /// Declares fields that are read without effect; one warning names those that are given.
    void without_effect(std::span<const std::string_view> fields, std::string_view why) {
        idle_ = {fields, why};
    }

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || block_.spelling(element.word) != info_.name)
            return false;
        OpenBlock inner(block_.binder, info_.name, element.word_span);
        inner.item = &info_;
        inner.ignored = effectless_;
        if (given_) *given_ = true;
        ItemReader fields(inner, info_, item_);
        inner.read(element.body, fields);
        block_.broken |= inner.broken;
        warn_of_idle_fields(block_, info_.name, fields, idle_, element.word_span);
        return true;
    }

    void add_words(WordList& words) const { words.push_back(info_.name); }

private:
    OpenBlock& block_;
    const ItemInfo& info_;
    void* item_;
    bool* given_;
    std::string_view effectless_;
    IdleFields idle_ = {};
};

}  // namespace candelabra
