// SPDX-License-Identifier: GPL-3.0-or-later
// Support for the actions of grammar/scene.yy: the tree under construction, and lists of nodes.
#pragma once

#include "syntax/brackets.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <bitset>
#include <new>
#include <unordered_map>

namespace candelabra {

/// A range of the parsed text, in bytes.
struct Stretch {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    Stretch() = default;
    constexpr Stretch(std::uint32_t first, std::uint32_t last) : first(first), last(last) {}
    /// For Bison's parser, whose initial location has lines and columns.
    constexpr Stretch(int, int, int, int) {}
};

/// The smallest stretch that covers both.
constexpr Stretch join(Stretch a, Stretch b) {
    return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

using TokenKinds = std::bitset<128>;

/// The token kind of a grammar symbol. Symbols are numbered as TokenKind, after the end, the error
/// token and the undefined token.
constexpr TokenKind token_kind(int symbol) {
    return symbol == 0 ? TokenKind::end_of_file : static_cast<TokenKind>(symbol - 2);
}

// Values that the parser copies millions of times are one word of 64 bits each: reading back a word
// right after writing a part of it stalls the processor.

/// A list of nodes under construction.
class List {
public:
    List() = default;
    List(NodeId first, NodeId last, bool comma)
        : bits_(static_cast<std::uint64_t>(last) << 33 | std::uint64_t{comma} << 32 |
                static_cast<std::uint64_t>(first)) {}

    /// no_node if empty.
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

/// A node::Literal in one word.
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

/// The value of a grammar symbol. The grammar declares which member it uses.
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
    bool postpones;  ///< keeps errors in branches of conditions and in macros for later
    std::unordered_map<NodeId, NodeId> last_channels = {};  ///< by colour
    std::unordered_map<NameId, NodeId> parameters = {};     ///< of the macro that is being read

    Span span(Stretch place) const { return {tree.source, place.first, place.last}; }
    NodeId add(Stretch place, NodeContent content) { return tree.add(span(place), content); }

    List append(List list, NodeId node);
    List joined(List, List);
    /// Adds a comma between elements. Two in a row are reported.
    List comma(List list, Stretch);
    /// The same where an element may be left out, which a node::Omitted stands for.
    List comma_or_gap(List list, Stretch);
    /// To be called at the end of such a list: adds what may be missing behind its last comma.
    List last_gap(List list, Stretch end);

    NodeId negative(NodeId operand, Stretch);
    /// Whether the operand may expand to text with operators of the expression around it.
    bool may_be_text(NodeId operand) const;
    /// `a + b`; a chain if an operand is one.
    NodeId binary(Operator, NodeId left, NodeId right, Stretch);
    /// An expression that a directive continues.
    NodeId goes_on(NodeId expression, NodeId directive, Stretch);
    /// The operands and the expression after a directive with a part that ends in an operator.
    NodeId continued(List operands, NodeId expression, Stretch);
    /// The operator and expression that begin a part of a directive that continues an expression.
    NodeId joining(Operator, NodeId expression, Stretch);
    NodeId group(List directives, List values, Stretch);
    NodeId vector(List components, Stretch);
    NodeId layered(List blocks, Stretch);
    NodeId declared(NodeId declare, bool local, Stretch);
    /// A part of a condition, up to `end`; without a condition, #else.
    NodeId branch(NodeId condition, List body, Stretch, std::uint32_t end);
    /// Returns the body, whose text is `part`, or a node::Postponed if there are errors in it.
    /// `alone`: counts only errors that point at nothing outside of the part.
    NodeId unless_wrong(List body, Stretch part, bool alone = false);
    /// Moves the errors in a part of the text from the diagnostics to a node::Postponed. Returns
    /// no_node if there are none.
    NodeId postponed(Stretch part, bool alone);
    /// A colour with one more channel.
    NodeId with_channel(NodeId colour, NodeId channel, Stretch);
    /// The body of a function that begins with a word: `pattern { ... }`, `internal(4)`.
    List word_first(NameId word, Stretch, List rest);
    /// Joins the parameters of a function with commas, `a, b`, and without, `c d`.
    List without_commas(List values, List names);
    /// Adds a parameter with its contract; or, behind another without a comma, more of that one's
    /// contract.
    List parameter(List list, NameId name, Stretch, List contract);
    /// Adds to what an argument must be.
    void agree(NodeId parameter, List contract, std::uint32_t end);
    /// Reports a second parameter of this name.
    void note_parameter(NameId name, NodeId, Stretch);
    /// Reports `array(3)`.
    NodeId array_in_parentheses(Stretch);
    NodeId stray_semicolon(Stretch);
    /// Reports `#version unofficial megapov 1.0`, the version of another program.
    NodeId patched_version(NameId program, Stretch);
    /// The operands of an expression without parentheses, in the form that a chain has them.
    List operands(NodeId expression);
    List with_operands(List, Operator, NodeId expression);
    /// Reports an unexpected token, and the tokens that could stand there.
    void report_unexpected(TokenKind found, Stretch, const TokenKinds& expected) const;
};

}  // namespace candelabra
