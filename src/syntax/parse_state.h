// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of grammar/scene.yy work with: the tree that grows, and the joining of nodes to
// lists.
#pragma once

#include "syntax/brackets.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

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

    NodeId add(Span span, NodeContent content) { return tree.add(span, content); }

    List append(List list, NodeId node);
    List joined(List, List);
    /// A comma between elements; only two in a row are wrong.
    List comma(List list, Span);
    /// Puts a node behind the others of a short list.
    NodeId chain(NodeId first, NodeId node);

    NodeId negative(NodeId operand, Span);
    NodeId group(List directives, List values, Span);
    NodeId vector(List components, Span);
    NodeId layered(List blocks, Span);
    NodeId declared(NodeId declare, bool local, Span);
    /// A colour with one more channel.
    NodeId with_channel(NodeId colour, NodeId channel, Span);
    /// The body of a function that begins with a word: `pattern { ... }`, `internal(4)`.
    List word_first(NameId word, Span, List rest);
    List parameter(List list, NameId name, Span);
    NodeId stray_semicolon(Span);
    /// `#version unofficial megapov 1.0`: the language of another program.
    NodeId patched_version(NameId program, Span);
};
