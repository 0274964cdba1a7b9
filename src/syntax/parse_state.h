// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of grammar/scene.yy work with: the tree that grows, and the joining of nodes to
// lists.
#pragma once

#include "syntax/brackets.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <bitset>
#include <new>

namespace candelabra {

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

// What the parser copies from place to place, millions of times, is one word of 64 bits each: a
// word that is read back right after a part of it has been written makes the processor wait.

/// A list of nodes that is being made.
class List {
public:
    List() = default;
    List(NodeId first, NodeId last, bool comma)
        : bits_(static_cast<std::uint64_t>(last) << 33 | std::uint64_t{comma} << 32 |
                static_cast<std::uint64_t>(first)) {}

    /// no_node when it is empty.
    NodeId first() const { return NodeId{static_cast<std::uint32_t>(bits_)}; }
    /// Precondition: not empty.
    NodeId last() const { return NodeId{static_cast<std::uint32_t>(bits_ >> 33)}; }
    /// Whether its last token is a comma.
    bool comma() const { return (bits_ >> 32 & 1) != 0; }
    bool empty() const { return first() == no_node; }
    List with_comma(bool comma) const { return {first(), last(), comma}; }

private:
    std::uint64_t bits_ = static_cast<std::uint64_t>(no_node);
};

/// A small value that takes a whole word.
template <class T>
class Wide {
public:
    Wide& operator=(T value) {
        bits_ = static_cast<std::uint64_t>(value);
        return *this;
    }
    operator T() const { return static_cast<T>(bits_); }

private:
    std::uint64_t bits_;
};

/// The numbers of a vector in the tree.
class WideLiteral {
public:
    WideLiteral& operator=(const node::Literal& literal) {
        bits_ = std::uint64_t{literal.count} << 32 | literal.first_number;
        return *this;
    }
    operator node::Literal() const {
        return {static_cast<std::uint32_t>(bits_), static_cast<std::uint32_t>(bits_ >> 32)};
    }

private:
    std::uint64_t bits_;
};

/// What a symbol of the grammar stands for, which of them the grammar says.
union SemanticValue {
    SemanticValue() : list() {}

    List list;
    Wide<NodeId> node;
    Wide<NameId> name;
    Wide<std::uint32_t> number;
    WideLiteral literal;
    Wide<bool> flag;
};
static_assert(sizeof(SemanticValue) == 8);

struct ParseState {
    Tree& tree;
    Names& names;
    Brackets& brackets;
    Diagnostics& diagnostics;
    std::string_view text;
    bool postpones;  ///< errors in branches of conditions and in macros

    Span span(Stretch place) const { return {tree.source, place.first, place.last}; }
    NodeId add(Stretch place, NodeContent content) { return tree.add(span(place), content); }

    List append(List list, NodeId node);
    List joined(List, List);
    /// A comma between elements; only two in a row are wrong.
    List comma(List list, Stretch);
    /// Puts a node behind the others of a short list.
    NodeId chain(NodeId first, NodeId node);

    NodeId negative(NodeId operand, Stretch);
    /// Whether its text may have operators that belong to the expression around it.
    bool may_be_text(NodeId operand) const;
    /// `a + b`; part of the chain when one of them is one.
    NodeId binary(Operator, NodeId left, NodeId right, Stretch);
    /// An expression that a directive goes on with.
    NodeId goes_on(NodeId expression, NodeId directive, Stretch);
    /// What comes behind a directive of which a part ends in an operator.
    NodeId continued(List operands, NodeId expression, Stretch);
    /// What the directive goes on with.
    NodeId joining(Operator, NodeId expression, Stretch);
    NodeId group(List directives, List values, Stretch);
    NodeId vector(List components, Stretch);
    NodeId layered(List blocks, Stretch);
    NodeId declared(NodeId declare, bool local, Stretch);
    /// The part of a condition that ends before `end`; no condition: #else.
    NodeId branch(NodeId condition, List body, Stretch, std::uint32_t end);
    /// The body, which is that part of the text, or what stands for it if there are errors in it.
    /// `alone`: only if they point at nothing outside of it.
    NodeId unless_wrong(List body, Stretch part, bool alone = false);
    /// What stands for a part with errors in it: they are taken away from the diagnostics. no_node:
    /// there are none.
    NodeId postponed(Stretch part, bool alone);
    /// A colour with one more channel.
    NodeId with_channel(NodeId colour, NodeId channel, Stretch);
    /// The body of a function that begins with a word: `pattern { ... }`, `internal(4)`.
    List word_first(NameId word, Stretch, List rest);
    /// `a, b` and `c d` of a function's parameters.
    List without_commas(List values, List names);
    List parameter(List list, NameId name, Stretch);
    /// `array(3)`
    NodeId array_in_parentheses(Stretch);
    NodeId stray_semicolon(Stretch);
    /// `#version unofficial megapov 1.0`: the language of another program.
    NodeId patched_version(NameId program, Stretch);
    /// What an expression without parentheses around it consists of, as in a chain.
    List operands(NodeId expression);
    List with_operands(List, Operator, NodeId expression);
    /// Says that a token does not fit, and what could stand there.
    void report_unexpected(TokenKind found, Stretch, const TokenKinds& expected) const;
};

}  // namespace candelabra
