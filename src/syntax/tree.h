// SPDX-License-Identifier: GPL-3.0-or-later
// The syntax tree of a file, which the parser builds and the evaluator walks. All nodes of a file
// are in one array and refer to each other by index, so a tree of any depth or size is copied,
// freed and kept without recursion. Every node has its place in the source.
#pragma once

#include "text/diagnostic.h"
#include "vocabulary/words.h"

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

/// The index of a node in its tree.
enum class NodeId : std::uint32_t {};

inline constexpr NodeId no_node{~std::uint32_t{0}};

enum class Operator : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,
    less,
    less_equal,
    equal,
    not_equal,
    greater_equal,
    greater,
    both,
    either,
    plus,
    minus,
    no,
};

/// The sign of an operator as it is written.
std::string_view spelling(Operator);

/// The directives that print a message.
enum class MessageKind : std::uint8_t { debug, warning, error, render, statistics };

/// The nodes. A member that is a list refers to its first node; the others follow by Node::next.
namespace node {

/// Text that could not be read and has been reported.
struct Broken {};

// Values
struct Number {
    std::uint32_t number;
};  ///< index in Tree::numbers
struct Literal {
    std::uint32_t first_number, count;
};  ///< `<1, -2, .5>`: a vector of nothing but numbers
struct Text {
    std::uint32_t text;
};  ///< index in Tree::texts
struct Name {
    NameId name;
};
struct Word {
    NameId word;
};  ///< a word or channel that stands alone
struct Constant {
    NameId word;
};
struct Index {
    NameId name;
    NodeId indices;
};  ///< `A[i][j]`
struct Member {
    NodeId operand;
    NameId member;
};
struct Call {
    NameId name;
    NodeId arguments;
};  ///< of a function (a reserved word) or a macro
struct Apply {
    NodeId function, arguments;
};  ///< `A[i](x, y, z)`; function: an Index
struct Unary {
    Operator sign;
    NodeId operand;
};
struct Binary {
    NodeId left, right;
    Operator sign;
    bool open = false;  ///< an operand, a macro or directive, may be text with operators
};
struct Choice {
    NodeId condition, yes, no;
};
struct Joined {
    Operator sign;
    NodeId operand;
};  ///< `+ b`, in a chain
struct Chain {
    NodeId first, last;
};  ///< `a #if (c) + b #end`: an operand, then Joined and directives, whose bodies are chains of
    ///< these; or `#if (c) a * #end b`: a directive, then the other operand
struct Omitted {
    bool last;      ///< behind the last comma, where nothing need be missing
};                  ///< what a comma shows to be left out: `M(1,, 3)`, `optional { 1,, 3 }`
struct Nothing {};  ///< the operand after an operator, which follows the directive around it
struct Group {
    NodeId content;
};  ///< `( ... )`: directives, then one value
struct Tuple {
    NodeId content;
};  ///< `(a, b)`
struct Vector {
    NodeId components;
};
struct Prefixed {
    NameId prefix;
    NodeId operand;
};  ///< `rgb E`
struct Colour {
    NodeId base, channels;
};  ///< `color E`, `color red 1`, `rgb E filter F`
struct Channel {
    NameId channel;
    NodeId operand;
};
struct Array {
    NodeId sizes, content;
    bool mixed;  ///< elements may be of several kinds
};               ///< sizes: no_node if it grows; content: a Braces or no_node
struct Function {
    NodeId parameters, body;
};

// Elements
struct Block {
    NameId word;
    NodeId body;
};  ///< `sphere { ... }`
struct Layers {
    NodeId blocks;
};  ///< two or more blocks as one value
struct Entry {
    NodeId body;
};  ///< `[ ... ]`
struct Braces {
    NodeId body;
    bool optional = false;  ///< some of its elements may be missing
};                          ///< `{ ... }` without a word

// Directives
struct Declare {
    NodeId target;  ///< Name, Index or Tuple
    NodeId value;
    bool local;
    bool semicolon;
};
struct Deprecated {
    NodeId declare;
    NodeId text;
    bool once;
};  ///< `#declare deprecated "..." A = ...`
struct Undef {
    NodeId target;
};
struct If {
    NodeId branches;
};
struct Branch {
    NodeId condition, body;
};  ///< condition no_node: `#else`
struct Postponed {
    std::uint32_t index;
};  ///< a part of a condition with errors in it: index in Tree::postponed
struct Defined {
    NodeId target;
    bool negated;
};  ///< the condition of `#ifdef`, `#ifndef`
struct While {
    NodeId condition, body;
};
struct For {
    NodeId target, range, body;
};  ///< range: start, end and perhaps step
struct Switch {
    NodeId subject, opening, cases;
};  ///< opening: elements before the first case
struct Case {
    NodeId values, body;
};  ///< one value: `#case`, two: `#range`, none: `#else`
struct Break {};
struct Macro {
    NameId name;
    NodeId parameters, body;
};
struct Parameter {
    NameId name;
    NodeId contract;  ///< a list of Kind and Bound: what an argument must be
    bool optional;
};
/// A word of a contract: a kind of value, `whole`, or `or` between two kinds.
struct Kind {
    NameId word;
    std::uint32_t dimensions;  ///< of `array[][]`; 0: any number
};
/// `>= 1`
struct Bound {
    NodeId value;  ///< a number, a constant or a name
    Operator sign;
};
struct Include {
    NodeId file;
};
struct Default {
    NodeId body;
};
struct Message {
    MessageKind kind;
    NodeId text;
};
struct Version {
    NodeId value;
    bool unofficial;
};
struct Open {
    NameId file;
    NodeId path;
    NameId mode;
};
struct Close {
    NameId file;
};
struct Read {
    NodeId content;
};
struct Write {
    NodeId content;
};

}  // namespace node

using NodeContent = std::variant<
    node::Broken, node::Number, node::Literal, node::Text, node::Name, node::Word, node::Constant,
    node::Index, node::Member, node::Call, node::Apply, node::Unary, node::Binary, node::Choice,
    node::Joined, node::Chain, node::Nothing, node::Omitted, node::Group, node::Tuple, node::Vector,
    node::Prefixed, node::Colour, node::Channel, node::Array, node::Function, node::Block,
    node::Layers, node::Entry, node::Braces, node::Declare, node::Deprecated, node::Undef, node::If,
    node::Branch, node::Postponed, node::Defined, node::While, node::For, node::Switch, node::Case,
    node::Break, node::Macro, node::Parameter, node::Kind, node::Bound, node::Include,
    node::Default, node::Message, node::Version, node::Open, node::Close, node::Read, node::Write>;

struct Node {
    std::uint32_t first = 0;  ///< offset in bytes in the tree's source
    std::uint32_t last = 0;
    NodeId next = no_node;  ///< the following node of the same list
    NodeContent content;
};
static_assert(sizeof(Node) <= 28 && std::is_trivially_copyable_v<Node>);

namespace tree_detail {
template <class T, std::size_t... I>
constexpr std::size_t position(std::index_sequence<I...>) {
    return ((std::is_same_v<T, std::variant_alternative_t<I, NodeContent>> ? I : 0) + ...);
}
}  // namespace tree_detail

/// `switch (node.content.index()) { case kind<node::Number>: ... }`
template <class T>
inline constexpr std::size_t kind =
    tree_detail::position<T>(std::make_index_sequence<std::variant_size_v<NodeContent>>());

/// `local.N` or `global.N`: a name by itself, for the binding of N in the innermost frame or in the
/// outermost.
struct ScopedName {
    NameId whole, name;
    bool global;
};

struct Tree {
    SourceId source = no_source;
    NodeId first = no_node;  ///< of the list of the file's elements
    std::vector<Node> nodes;
    std::vector<double> numbers;
    std::vector<std::string> texts;  ///< strings with their escapes replaced
    /// Indices, ascending, of the strings without escapes: names of files.
    std::vector<std::uint32_t> verbatim;
    std::vector<ScopedName> scoped;
    std::vector<std::vector<Diagnostic>> postponed;  ///< reported when the walk reaches them

    const Node& operator[](NodeId id) const { return nodes[static_cast<std::size_t>(id)]; }
    Node& operator[](NodeId id) { return nodes[static_cast<std::size_t>(id)]; }
    template <class T>
    const T& get(NodeId id) const {
        return *std::get_if<T>(&(*this)[id].content);
    }
    template <class T>
    const T* get_if(NodeId id) const {
        return id == no_node ? nullptr : std::get_if<T>(&(*this)[id].content);
    }
    /// Whether the node is a directive with parts.
    bool gives_elements(NodeId id) const {
        return get_if<node::If>(id) || get_if<node::While>(id) || get_if<node::For>(id) ||
               get_if<node::Switch>(id);
    }
    Span span(NodeId id) const { return {source, (*this)[id].first, (*this)[id].last}; }

    NodeId add(Span span, NodeContent content) {
        nodes.push_back({span.first, span.last, no_node, content});
        return NodeId(nodes.size() - 1);
    }
};

/// Some elements of a tree: the content of a block, a loop, a macro, or a file.
struct Body {
    const Tree* tree = nullptr;
    NodeId first = no_node;
};

}  // namespace candelabra
