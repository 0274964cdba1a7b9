// SPDX-License-Identifier: GPL-3.0-or-later
// One block while it is read. Several readers share its elements: one that waits for a value is
// asked first, then each in turn; what none of them takes is reported here, once, and whatever
// belongs to it is passed over. A reader has
//
//     bool waiting() const;             the next element may be for it, before all others
//     bool wants() const;               it misses something: an unknown name would have been that
//     bool take(const Element&);        true: the element was its own, and has been dealt with
//     void finish();                    the block has ended
//     void add_words(WordList&) const;  the words that it takes, for "did you mean"
#pragma once

#include "bind/binder.h"
#include "bind/misplaced.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

using ElementList = std::vector<Element>;

class OpenBlock {
public:
    /// `name` is the word in front of the brace, and lives as long as this.
    OpenBlock(Binder& binder, std::string_view name, Span span)
        : binder(binder), name(name), span(span) {}
    OpenBlock(const OpenBlock&) = delete;
    OpenBlock& operator=(const OpenBlock&) = delete;

    Binder& binder;
    std::string_view name;
    Span span;  ///< of the block's word: where what is missing is reported
    /// What follows the name, braces and all; empty: by the item's vocabulary.
    std::string_view form = {};
    const ItemInfo* item = nullptr;  ///< what the block describes
    std::string_view ignored = {};   ///< words of POV-Ray that may stand here and change nothing
    bool broken = false;  ///< something has been reported: do not speak of what follows from it
    int taken = 0;        ///< elements that readers took
    Span file_span = {};  ///< of the name of a file that the block has given
    std::string_view file_kind = {};  ///< the word before that name: `png`; empty: none
    void note_file(Span name, std::string_view kind) {
        file_span = name;
        if (!kind.empty()) file_kind = kind;
    }
    /// Where to report what is wrong with that file.
    Span file_place() const { return file_span.known() ? file_span : span; }
    /// Textures of the parts of a shape; null where parts have none.
    std::vector<Handle<Texture>>* part_textures = nullptr;

    template <class... Readers>
    void read(Body, Readers&...);
    /// The same with elements that have been looked at before.
    template <class... Readers>
    void read(const ElementList&, Readers&...);

    /// What has been passed over has ended: an element came that belongs here.
    void resume() { misplaced_.resume(); }
    /// For an element outside of all readers.
    void refuse(const Element&, const WordList& words);

    /// As the evaluator does; an error makes the block broken.
    void report(Diagnostic);
    /// The help line that shows how the block is written.
    std::string help() const;
    std::string quoted() const;
    std::string_view spelling(NameId word) const { return binder.evaluator.spelling(word); }

private:
    /// `walk` calls what it is given with each element.
    template <class Walk, class... Readers>
    void read_each(Walk walk, Readers&...);
    Misplaced misplaced_{*this};
};

/// What has no words and never waits: a start for readers that need little.
struct SimpleReader {
    bool waiting() const { return false; }
    bool wants() const { return false; }
    void finish() {}
    void add_words(WordList&) const {}
};

/// `Name` of a declared T as the first element of a block: it starts from a copy.
template <class T, class Use>
class NamedReader : public SimpleReader {
public:
    NamedReader(OpenBlock& block, Use use) : block_(block), use_(std::move(use)) {}

    bool wants() const { return block_.taken == 0; }
    bool take(const Element& element) {
        if (element.kind != Element::Kind::value) return false;
        const Handle<T> part = element.value.handle<T>();
        if (!part) return false;
        if (block_.taken > 0)
            block_.report(error(
                Fault::misplaced, element.span,
                "what is declared must come first: it would replace all that is before it in " +
                    block_.quoted()));
        use_(part);
        return true;
    }

private:
    OpenBlock& block_;
    Use use_;
};
template <class T, class Use>
NamedReader<T, Use> named(OpenBlock& block, Use use) {
    return NamedReader<T, Use>(block, std::move(use));
}

template <class... Readers>
void OpenBlock::read(Body body, Readers&... readers) {
    read_each([&](const auto& take) { binder.evaluator.walk(body, take); }, readers...);
}

template <class... Readers>
void OpenBlock::read(const ElementList& elements, Readers&... readers) {
    read_each([&](const auto& take) { std::ranges::for_each(elements, take); }, readers...);
}

template <class Walk, class... Readers>
void OpenBlock::read_each(Walk walk, Readers&... readers) {
    const auto offer = [&](const Element& element) {
        return ((readers.waiting() && readers.take(element)) || ...) ||
               (readers.take(element) || ...);
    };
    walk([&](const Element& element) {
        if (misplaced_.passes_over(element)) return;
        if (offer(element)) {
            ++taken;
            return;
        }
        // Apart: blocks lie inside each other, and each would set aside its room on the stack.
        const auto refused = [&]() __attribute__((noinline)) {
            WordList words;
            (readers.add_words(words), ...);
            if (!misplaced_.reject(element, words, (readers.wants() || ...))) return;
            Element hole = element;
            hole.kind = Element::Kind::value;
            hole.value = Absence::broken;
            offer(hole);
        };
        refused();
    });
    if (!binder.evaluator.stopped()) (readers.finish(), ...);
}

}  // namespace candelabra
