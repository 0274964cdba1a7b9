// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/misplaced.h"

#include "interpret/previous.h"
#include "reading/block.h"
#include "reading/unbracketed_vector.h"
#include "syntax/foreign.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "vocabulary/glossary.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Words that follow a word without effect and are not worth a warning.
constexpr std::string_view values_of_charset = "utf8 ascii sys";

bool contains(std::string_view list, std::string_view word) {
    for (std::size_t at = list.find(word); at != std::string_view::npos;
         at = list.find(word, at + 1)) {
        const bool starts = at == 0 || list[at - 1] == ' ';
        const std::size_t last = at + word.size();
        if (starts && (last == list.size() || list[last] == ' ')) return true;
    }
    return false;
}

bool has_word(const WordList& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

/// The first word with this beginning, such as `look_at` for `look_`; empty if there is none.
std::string_view beginning_with(const WordList& words, std::string_view beginning) {
    const auto found = std::ranges::find_if(
        words, [&](std::string_view word) { return word.starts_with(beginning); });
    return found == words.end() ? std::string_view() : *found;
}

/// The block's equivalent of a word from other programs; empty if there is none.
std::string_view foreign_here(std::string_view word, const WordList& words) {
    for (const std::string_view meant : foreign_word(word))
        if (has_word(words, meant)) return meant;
    return {};
}

/// The name directly after a word, or dots.
std::string_view named_behind(const Element& word, const Names& names) {
    const auto& [tree, node] = word.origin;
    const NodeId next = tree && node != no_node ? (*tree)[node].next : no_node;
    const auto* name = next == no_node ? nullptr : tree->get_if<node::Name>(next);
    return name ? names.spelling(name->name) : "...";
}

/// The kind of the value without an article: "texture", not "a texture".
std::string bare_kind(const Value& value) {
    const std::string kind = kind_name(value);
    return kind.substr(kind.find(' ') + 1);
}

}  // namespace

bool Misplaced::passes_over(const Element& element) {
    const bool value = element.kind == Element::Kind::value || element.kind == Element::Kind::list;
    passing_over_ =
        (value && passing_over_) ||
        (block_.name.empty() && follows_report(element, block_.binder.evaluator.diagnostics()));
    return passing_over_;
}

bool Misplaced::reject(const Element& element, const WordList& words, bool wanted) {
    switch (element.kind) {
        case Element::Kind::value:
            reject_value(element);
            return false;
        case Element::Kind::word:
        case Element::Kind::block:
            return reject_word(element, words, wanted);
        case Element::Kind::entry:
            reject_form(element, "an entry in brackets has", wanted);
            return false;
        case Element::Kind::braces:
            reject_form(element, "braces without a word before them have");
            return false;
        case Element::Kind::list:
            reject_form(element, "a list of numbers has");
            return false;
        case Element::Kind::joined:
            reject_form(element, "an operator without an expression before it has");
            return false;
        case Element::Kind::omitted:
            reject_form(element, "a comma without a value before it has");
            return false;
    }
    return false;
}

void Misplaced::reject_form(const Element& element, std::string_view what, bool wanted) {
    if (!block_.broken)
        block_.report(
            error(Fault::misplaced, element.span, message(what, " no place in ", block_.quoted()))
                .with_help(wanted ? "a vector is written between `<` and `>`: <1, 2, 3>"
                                  : block_.help()));
}

void Misplaced::ask_for_braces(const Element& element) {
    const std::string_view word = block_.spelling(element.word);
    block_.report(
        error(Fault::missing, element.word_span,
              message("what belongs to `", word, "` stands in braces"))
            .with_help(message("write `", word, " { ",
                               named_behind(element, block_.binder.evaluator.names()), " }`")));
}

bool Misplaced::reject_word(const Element& element, const WordList& words, bool wanted) {
    const std::string_view word = block_.spelling(element.word);
    passing_over_ = true;
    // A word without effect causes a warning only, so errors after it are still reported.
    if (!contains(block_.ignored, word)) block_.binder.evaluator.note_reported(element.origin);
    if (element.kind == Element::Kind::word && block_.binder.blocks.takes_braces(element.word) &&
        has_word(words, word)) {
        if (!reported_unavailable_) ask_for_braces(element);
        reported_unavailable_ = !block_.name.empty();
        unbraced_ = word;
        return false;
    }
    if (in_comment(element)) return false;
    const std::string_view meant = foreign_here(word, words);
    if (block_.binder.evaluator.names().reserved(element.word) && meant.empty()) {
        reject_reserved(element, word);
        return false;
    }
    const std::string_view before = std::exchange(rejected_, word);
    if (!before.empty() && has_word(words, message(before, '_', word))) return false;
    std::string near = nearest(word, words);
    if (near.empty()) near = beginning_with(words, message(word, '_'));
    if (!meant.empty()) near = meant;
    if (near == word) {
        ask_for_braces(element);
        return false;
    }
    if (!near.empty()) {
        block_.report(error(Fault::unknown_word, element.word_span,
                            message(block_.quoted(), " has no word `", word, "`"))
                          .with_help(message("did you mean `", near, "`?")));
        return false;
    }
    const bool block = element.kind == Element::Kind::block;
    // Words of the language are in lower case.
    const bool capital = word.front() >= 'A' && word.front() <= 'Z';
    if (block ||
        (!wanted && !capital && nearest(word, block_.binder.evaluator.declared_names()).empty())) {
        Diagnostic unknown = error(Fault::unknown_word, element.word_span,
                                   message(block_.quoted(), " has no word `", word, "`"));
        const Value* declared = block ? block_.binder.evaluator.find(element.word) : nullptr;
        const std::string bare = declared ? bare_kind(*declared) : std::string();
        const std::string_view way_out = foreign_name(word);
        std::string list;
        for (const std::string_view home : block_.binder.blocks.homes(word))
            if (block && way_out.empty()) list += message(list.empty() ? "" : ", ", '`', home, '`');
        if (!list.empty()) unknown.with_note(message("it belongs in ", list));
        block_.report(std::move(unknown.with_help(
            block_.binder.blocks.knows(bare) ? message("write `", bare, " { ", word, " ... }`")
            : way_out.empty()                ? block_.help()
                                             : std::string(way_out))));
        return false;
    }
    // Reports it as in an expression: the evaluator knows which names the library declares.
    block_.binder.evaluator.value_of(element);
    block_.broken = true;
    passing_over_ = false;
    return true;
}

/// Whether the element belongs to three or more adjacent undeclared words, such as a comment in the
/// syntax of another language. Reports them once, at the first word.
bool Misplaced::in_comment(const Element& element) {
    const auto& [tree, node] = element.origin;
    if (!tree || node == no_node || !block_.name.empty()) return false;
    const Body next{tree, (*tree)[node].next};
    if (tree == comment_.tree && node == comment_.first) {
        comment_ = next;
        return true;
    }
    if (!begins_comment(element, block_.binder.evaluator)) return false;
    block_.report(error(Fault::unknown_name, element.word_span,
                        message("nothing is declared as `", block_.spelling(element.word), "`"))
                      .with_help("a comment begins with `//`"));
    comment_ = next;
    return true;
}

/// A declared name that differs from the word only in letter case; empty if there is none.
std::string_view Misplaced::in_other_case(std::string_view word) const {
    for (const std::string_view name : block_.binder.evaluator.declared_names())
        if (same_letters(name, word)) return name;
    return {};
}

void Misplaced::reject_reserved(const Element& element, std::string_view word) {
    const WordClass kind = block_.binder.evaluator.names().word_class(element.word);
    if (kind == WordClass::colour_prefix || kind == WordClass::channel) {
        const bool channel = kind == WordClass::channel;
        block_.report(
            error(
                Fault::missing, element.word_span,
                message('`', word, "` needs ", channel ? "" : "a vector or ", "a number behind it"))
                .with_help(channel ? "colors.inc declares the colours Red, Green, Blue" : ""));
        block_.broken = true;
        return;
    }
    if (contains(block_.ignored, word)) {
        if (!contains(values_of_charset, word) && block_.binder.warned.emplace(word).second)
            block_.report(warning(Fault::no_effect, element.word_span,
                                  message('`', word, "` has no effect in this version")));
        return;
    }
    if (const std::string_view declared = in_other_case(word); !declared.empty()) {
        block_.report(
            error(Fault::unknown_name, element.word_span,
                  message('`', word, "` is a word of the language, and has no place here"))
                .with_help(message("did you mean `", declared, "`, which is declared?")));
        block_.broken = true;
        return;
    }
    if (block_.binder.blocks.knows(word)) {
        // It may belong to an unavailable word, or to one whose braces are missing.
        const std::vector<std::string_view> places = block_.binder.blocks.homes(word);
        if (reported_unavailable_ || std::ranges::find(places, unbraced_) != places.end()) return;
        const bool block = element.kind == Element::Kind::block;
        if (block && std::ranges::find(places, block_.name) != places.end()) {
            block_.report(error(Fault::misplaced, element.word_span,
                                message('`', word, "` takes what is behind it, without braces"))
                              .with_help(block_.help()));
            return;
        }
        Diagnostic misplaced = error(Fault::misplaced, element.word_span,
                                     message('`', word, "` has no place in ", block_.quoted()));
        std::string list;
        // Objects belong in too many blocks to list them.
        if (!block_.binder.blocks.makes_object(element.word))
            for (const std::string_view home : places)
                list += message(list.empty() ? "" : ", ", '`', home, '`');
        if (!list.empty()) misplaced.with_note(message("it belongs in ", list));
        block_.report(std::move(misplaced.with_help(block_.help())));
        return;
    }
    const GlossaryEntry* known = glossary_entry(word);
    if (known && says_available(known->help)) {
        block_.report(error(Fault::misplaced, element.word_span,
                            message('`', word, "` has no place in ", block_.quoted()))
                          .with_note(message("it is used as in `", known->form, '`')));
        block_.broken = true;
        return;
    }
    if (!reported_unavailable_)
        block_.report(error(Fault::not_implemented, element.word_span,
                            message('`', word, "` is not available in this version")));
    reported_unavailable_ = !block_.name.empty();
    block_.broken = true;
}

void Misplaced::reject_value(const Element& element) {
    if (element.value.broken()) block_.broken = passing_over_ = true;
    if (element.value.absent() || block_.broken) return;
    if (const auto bare = unbracketed_vector(element, block_.binder.evaluator.names()))
        return block_.report(*bare);
    if (const std::string meant = moved_without_times(element, block_.binder.evaluator.names());
        !meant.empty()) {
        block_.report(error(Fault::misplaced, element.span, "this value belongs to nothing")
                          .with_help(message("write `", meant, "`")));
        return;
    }
    if (const auto& [tree, node] = element.origin;
        tree && tree->get_if<node::Colour>(node) && contains(block_.ignored, "color"))
        return block_.report(warning(Fault::no_effect, element.span,
                                     message("`color` has no effect in ", block_.quoted()))
                                 .with_help(block_.name == "light_source"
                                                ? "a declared light keeps its colour"
                                                : "an object gets its colour from a pigment: "
                                                  "pigment { color rgb <1, 0, 0> }"));
    // Report only the first of several values in a scene.
    passing_over_ = block_.name.empty();
    const std::string kind = kind_name(element.value);
    const Numbers* numbers = element.value.numbers();
    const bool looks =
        block_.name == "texture" ||
        block_.binder.blocks.makes_object(block_.binder.evaluator.names().find(block_.name));
    const bool number = numbers && !(numbers->is_colour() && looks);
    if (numbers && !number) {
        block_.report(
            error(Fault::misplaced, element.span,
                  message(kind, " has no place in ", block_.quoted()))
                .with_help("an object gets its colour from a pigment: pigment { rgb <1, 0, 0> }"));
        return;
    }
    if (number && block_.item && !block_.item->fields.empty() &&
        block_.item->fields.front().place == Placement::positional) {
        if (const auto bare = unbracketed_vectors(element, *block_.item))
            return block_.report(*bare);
        const auto most = std::ranges::count_if(block_.item->fields, [](const FieldInfo& f) {
            return f.place == Placement::positional;
        });
        block_.report(error(Fault::wrong_count, element.span,
                            message(block_.quoted(), " takes ", most,
                                    most == 1 ? " value" : " values", ", but here is one more"))
                          .with_help(block_.help()));
        return;
    }
    Diagnostic stray =
        error(Fault::misplaced, element.span, message(kind, " has no place in ", block_.quoted()));
    const std::string bare = bare_kind(element.value);
    if (block_.name.empty() && element.value.text())
        stray.with_help(follows_message(element) ? "strings are joined by concat(a, b)"
                                                 : "#debug \"...\\n\" prints a string");
    else if (!number && element.word != no_name && block_.binder.blocks.knows(bare) &&
             bare != block_.name)
        stray.with_help(
            message("did you mean `", bare, " { ", block_.spelling(element.word), " }`?"));
    else
        stray.with_help(block_.help());
    block_.report(std::move(stray));
}

}  // namespace candelabra
