// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a block that selects one of several items by name, with fields behind the name or in braces
// of its own: `light_sampler { light_octree eta 0.01 }` or `index { kd_tree { node_cost 2 } }`.
// Used by the reader of settings.
#pragma once

#include "reading/block.h"
#include "reading/item_reader.h"
#include "text/message.h"
#include "vocabulary/kinds.h"

namespace candelabra {

/// Names of the block for messages.
struct ChoiceWords {
    std::string_view name;  ///< the word before the braces
    std::string_view noun;  ///< noun for the selected items
    std::string form;       ///< usage of the block, for help
};

/// Checks the selected item and the fields that were given to it.
template <class Variant>
using ChoiceCheck = void (*)(OpenBlock&, const Variant&, const ItemReader&, Span);

template <class Variant>
class ChoiceReader {
public:
    ChoiceReader(OpenBlock& block, const ChoiceWords& words, ChoiceCheck<Variant> check,
                 Variant& choice)
        : block_(block),
          words_(words),
          check_(check),
          choice_(choice),
          fields_(block, *All::infos[choice.index()], All::address(choice)) {}

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants(); }

    bool take(const Element& element) {
        const bool named =
            element.kind == Element::Kind::word || element.kind == Element::Kind::block;
        const std::size_t kind = !fields_.waiting() && element.word != no_name
                                     ? All::find(block_.spelling(element.word))
                                     : All::count;
        if (kind == All::count) return chosen_ && fields_.take(element);
        // A name that the scene has declared as a value arrives as that value.
        if (!named && element.kind != Element::Kind::value) return false;
        if (chosen_) {
            block_.report(error(Fault::duplicate, element.word_span,
                                message('`', words_.name, "` has one ", words_.noun,
                                        ", and this is a second"))
                              .with_help(block_.help()));
            return true;
        }
        chosen_ = true;
        choice_ = All::make(kind);
        fields_.rebind(*All::infos[kind], All::address(choice_));
        if (element.kind == Element::Kind::block) read_parameters(element, *All::infos[kind]);
        return true;
    }

    void finish() {
        fields_.finish();
        check_(block_, choice_, fields_, block_.span);
        if (!chosen_ && !block_.broken)
            block_.report(error(Fault::missing, block_.span,
                                message('`', words_.name, "` needs the name of a ", words_.noun))
                              .with_help(block_.help()));
    }

    void add_words(WordList& words) const {
        for (const ItemInfo* info : All::infos) words.push_back(info->name);
        if (chosen_) fields_.add_words(words);
    }

private:
    using All = Kinds<Variant>;

    void read_parameters(const Element& element, const ItemInfo& info) {
        OpenBlock inner(block_.binder, info.name, element.word_span);
        inner.item = &info;
        ItemReader fields(inner, info, All::address(choice_));
        inner.read(element.body, fields);
        block_.broken |= inner.broken;
        check_(block_, choice_, fields, element.word_span);
    }

    OpenBlock& block_;
    const ChoiceWords& words_;
    ChoiceCheck<Variant> check_;
    Variant& choice_;
    ItemReader fields_;
    bool chosen_ = false;
};

/// Reads the block inside another one.
template <class Variant>
class ChoiceBlock : public SimpleReader {
public:
    ChoiceBlock(OpenBlock& block, ChoiceWords words, ChoiceCheck<Variant> check, Variant& choice)
        : block_(block), words_(std::move(words)), check_(check), choice_(choice) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || block_.spelling(element.word) != words_.name)
            return false;
        OpenBlock inner(block_.binder, words_.name, element.word_span);
        inner.form = words_.form;
        ChoiceReader<Variant> reader(inner, words_, check_, choice_);
        inner.read(element.body, reader);
        return true;
    }
    void add_words(WordList& words) const { words.push_back(words_.name); }

private:
    OpenBlock& block_;
    ChoiceWords words_;
    ChoiceCheck<Variant> check_;
    Variant& choice_;
};

}  // namespace candelabra
