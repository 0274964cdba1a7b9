// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a pattern and its values, modifiers, wave and warps in any block. Called by the readers of
// pigments and of all other patterned items.
#pragma once

#include "pattern/use.h"
#include "reading/item_reader.h"
#include "reading/transforms.h"
#include "scene/scene.h"
#include "text/message.h"

#include <functional>

namespace candelabra {

/// A pattern while it is read; converted to a PatternUse by use().
struct PatternDraft {
    std::optional<Pattern> pattern;
    PatternModifiers modifiers;
    Waveform wave;
    std::vector<WarpStep> steps;
    Transform transform;  ///< after all steps

    PatternDraft() = default;
    PatternDraft(const PatternUse&, const Transform&);
    void move(const Transform& next) { transform = transform.then(next); }
    void add(Warp);
    /// Precondition: it has a pattern.
    PatternUse use() const { return {*pattern, modifiers, wave, steps, hole_rows(steps)}; }
};

class PatternReader {
public:
    /// All arguments outlive the reader. `home` is the use of the pattern: "pigment", "normal" or
    /// "texture"; empty: none of these. `list_entry` is offered the elements behind the object in
    /// object { } and returns whether it took one.
    PatternReader(OpenBlock&, PatternDraft&, std::string_view home,
                  std::function<bool(const Element&)> list_entry = {});

    bool waiting() const;
    bool wants() const { return fields_.wants() || modifiers_.wants() || wave_.wants(); }
    bool take(const Element&);
    void finish();
    void add_words(WordList&) const;

    /// Whether the element names a pattern and is not a value that the reader waits for.
    bool names_pattern(const Element&) const;
    /// Whether the block has named its pattern instead of inheriting a declared one.
    bool named() const { return named_; }

private:
    bool take_value(const Element&);
    void take_function(Handle<Formula>, Span);
    bool take_word(const Element&);
    bool take_block(const Element&);
    bool read_in_braces(const Element&);
    bool belongs_here(Span);
    bool read_object_pattern(const Element&);
    void take_made(Pattern, Span);
    void name(std::size_t kind, Span word = {});
    void read_warp(const Element&);

    OpenBlock& block_;
    PatternDraft& draft_;
    std::string_view home_;
    ItemReader fields_;  ///< of the pattern; invalid before it is named
    ItemReader modifiers_;
    ItemReader wave_;             ///< invalid before a wave is named
    ItemReader* last_ = nullptr;  ///< the reader that took the last word, and takes its values
    std::function<bool(const Element&)> list_entry_;
    Span name_span_;
    bool named_ = false;
};

/// Reads the braces of `function { pattern { ... } }`. Returns false after a diagnostic.
bool read_pattern(Binder&, const Element& block, PatternDraft&);

/// Reads `uv_mapping` at the head of a block.
class UvReader : public SimpleReader {
public:
    explicit UvReader(OpenBlock& block) : block_(block) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::word || element.word != "uv_mapping"_word) return false;
        given = true;
        --block_.taken;  // a declared item may still come first behind it
        return true;
    }
    void add_words(WordList& words) const { words.push_back("uv_mapping"); }

    bool given = false;

private:
    OpenBlock& block_;
};

/// Reads the braces of a pigment or normal, or the part of a map's entry behind its number: a
/// declared item, the block's own words, transformations. Draft is the item under construction,
/// Reader reads its words; `plural` names such items in messages. Content is anything that a block
/// can read.
template <class Draft, class Reader, class Content, class Patterned, class... First>
void read_patterned(OpenBlock& block, const Content& content, Patterned& patterned,
                    std::string_view plural, First&... first) {
    Draft draft(patterned);
    auto declared = named<Patterned>(block, [&](const Handle<Patterned>& other) {
        if (!block.broken) draft = Draft(*other);
    });
    Reader reader(block, draft);
    const auto apply = [&](const Transform& transform) { draft.pattern.move(transform); };
    TransformReader moves(block, apply);
    UvReader uv(block);
    block.read(content, first..., declared, uv, reader, moves);
    if (block.broken) return;
    patterned = draft.made();
    patterned.uv = patterned.uv || uv.given;
    if (nesting(patterned).too_deep())
        block.report(error(
            Fault::recursion_limit, block.span,
            message("too many ", plural, " are nested here: each level can double the work")));
}

/// A pattern that is 1 inside of the object, 0 outside.
ObjectPattern object_pattern(const Object&);

}  // namespace candelabra
