// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of grammar/scene.yy work with: the tree that grows, and the joining of nodes to
// lists.
#pragma once

#include "syntax/brackets.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <bitset>
#include <new>

/// A stretch of the text that is parsed: its place.
struct Stretch {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    Stretch() = default;
    constexpr Stretch(std::uint32_t first, std::uint32_t last) : first(first), last(last) {}
    /// Bison's parsers begin at a place of lines and columns.
    constexpr Stretch(int, int, int, int) {}
};

/// The smallest stretch that covers both.
constexpr Stretch join(Stretch a, Stretch b) {
    return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

using TokenKinds = std::bitset<128>;

/// The numbers of the grammar's symbols are those of TokenKind, behind the end, the error token and
/// the undefined token.
constexpr TokenKind token_kind(int symbol) {
    return symbol == 0 ? TokenKind::end_of_file : static_cast<TokenKind>(symbol - 2);
}

/// A list of nodes that is being made.
struct List {
    NodeId first = no_node;
    NodeId last = no_node;
    bool comma = false;  ///< its last token is a comma
};

/// What a symbol of the grammar stands for, which of them the grammar says: copied from place to
/// place as it is, for there are millions.
union SemanticValue {
    SemanticValue() : list() {}

    List list;
    NodeId node;
    NameId name;
    std::uint32_t number;
    node::Literal literal;
    bool flag;
};

struct ParseState {
    Tree& tree;
    Names& names;
    Brackets& brackets;
    Diagnostics& diagnostics;
    std::string_view text;

    Span span(Stretch place) const { return {tree.source, place.first, place.last}; }
    NodeId add(Stretch place, NodeContent content) { return tree.add(span(place), content); }

    List append(List list, NodeId node);
    List joined(List, List);
    /// A comma between elements; only two in a row are wrong.
    List comma(List list, Stretch);
    /// Puts a node behind the others of a short list.
    NodeId chain(NodeId first, NodeId node);

    NodeId negative(NodeId operand, Stretch);
    NodeId group(List directives, List values, Stretch);
    NodeId vector(List components, Stretch);
    NodeId layered(List blocks, Stretch);
    NodeId declared(NodeId declare, bool local, Stretch);
    /// A colour with one more channel.
    NodeId with_channel(NodeId colour, NodeId channel, Stretch);
    /// The body of a function that begins with a word: `pattern { ... }`, `internal(4)`.
    List word_first(NameId word, Stretch, List rest);
    List parameter(List list, NameId name, Stretch);
    NodeId stray_semicolon(Stretch);
    /// `#version unofficial megapov 1.0`: the language of another program.
    NodeId patched_version(NameId program, Stretch);
    /// Says that a token does not fit, and what could stand there.
    void report_unexpected(TokenKind found, Stretch, const TokenKinds& expected) const;
};
