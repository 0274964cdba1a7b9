// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one block. Several readers share its elements: each is offered first to a reader that waits
// for a value, then to all in turn. An element that none of them takes is reported here once, and
// the elements that belong to it are skipped. A reader has
//
//     bool waiting() const;             the reader is offered the next element first
//     bool wants() const;               a value is missing: an unknown name may stand for it
//     bool take(const Element&);        whether the reader has consumed the element
//     void finish();                    the block has ended
//     void add_words(WordList&) const;  the words that it takes, for "did you mean"
#pragma once

#include "reading/binder.h"
#include "reading/misplaced.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

using ElementList = std::vector<Element>;
class PartLooks;

class OpenBlock {
public:
    /// `name` is the word before the brace and must outlive the block.
    OpenBlock(Binder& binder, std::string_view name, Span span)
        : binder(binder), name(name), span(span) {}
    OpenBlock(const OpenBlock&) = delete;
    OpenBlock& operator=(const OpenBlock&) = delete;

    Binder& binder;
    std::string_view name;
    Span span;  ///< place of the block's word, where missing parts are reported
    /// Usage text that follows the name, including the braces; empty: made from the item's
    /// vocabulary.
    std::string_view form = {};
    const ItemInfo* item = nullptr;   ///< the vocabulary of the item that the block describes
    std::string_view ignored = {};    ///< POV-Ray's words that are accepted here without effect
    bool broken = false;              ///< an error has been reported: its consequences are not
    int taken = 0;                    ///< number of elements that readers took
    Span file_span = {};              ///< place of the last file name in the block
    std::string_view file_kind = {};  ///< the word before that name, such as `png`; empty: none
    void note_file(Span name, std::string_view kind) {
        file_span = name;
        if (!kind.empty()) file_kind = kind;
    }
    /// Where to report problems with that file.
    Span file_place() const { return file_span.known() ? file_span : span; }
    /// Reads what the parts of a shape look like; null if its parts have no textures.
    PartLooks* part_looks = nullptr;

    template <class... Readers>
    void read(Body, Readers&...);
    /// Reads elements that have been collected before.
    template <class... Readers>
    void read(const ElementList&, Readers&...);

    /// Stops skipping elements: one came that belongs here.
    void resume() { misplaced_.resume(); }
    /// Reports an element that stands outside of all readers.
    void refuse(const Element&, const WordList& words);

    /// Reports through the evaluator; an error marks the block as broken.
    void report(Diagnostic);
    /// Help line that shows how to write the block.
    std::string help() const;
    std::string quoted() const;
    std::string_view spelling(NameId word) const { return binder.evaluator.spelling(word); }
    /// Whether the element is a block that makes an object.
    bool makes_object(const Element& element) const {
        return element.kind == Element::Kind::block && binder.blocks.makes_object(element.word);
    }

private:
    /// `walk` calls its argument with each element.
    template <class Walk, class... Readers>
    void read_each(Walk walk, Readers&...);
    Misplaced misplaced_{*this};
};

/// Base of readers that have no words and never wait.
struct SimpleReader {
    bool waiting() const { return false; }
    bool wants() const { return false; }
    void finish() {}
    void add_words(WordList&) const {}
};

/// Takes the name of a declared T as the first element of a block, which starts from a copy of it.
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
        // Kept out of line: blocks nest, and each level would reserve its stack space.
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
