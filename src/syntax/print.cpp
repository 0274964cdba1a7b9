// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/print.h"

#include "syntax/quoted.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace candelabra {

namespace {

/// A piece still to be written: text, a node, a list of nodes, or the end of an indentation.
struct Piece {
    enum class Kind { text, node, elements, commas, blanks, joined, leave };

    Kind kind;
    std::string text;
    NodeId id = no_node;
};

using Pieces = std::vector<Piece>;

Piece say(std::string text) { return {Piece::Kind::text, std::move(text), no_node}; }
Piece one(NodeId id) { return {Piece::Kind::node, {}, id}; }
/// Elements of a body, each on its own line.
Piece elements(NodeId first) { return {Piece::Kind::elements, {}, first}; }
Piece commas(NodeId first) { return {Piece::Kind::commas, {}, first}; }
Piece blanks(NodeId first) { return {Piece::Kind::blanks, {}, first}; }
/// `[1][2]`
Piece joined(NodeId first) { return {Piece::Kind::joined, {}, first}; }

/// Whether a string is a file name without escapes. It must directly follow the word before it.
bool is_verbatim(const Tree& tree, const node::Text& text) {
    return std::ranges::binary_search(tree.verbatim, text.text);
}

/// Whether a node is a word that would take a value after it as its own, as in `green A`.
bool takes_value(const Tree& tree, const Names& names, NodeId id) {
    const auto* word = tree.get_if<node::Word>(id);
    if (!word) return false;
    const WordClass word_class = names.word_class(word->word);
    return word_class == WordClass::channel || word_class == WordClass::colour_prefix;
}

/// Whether a node begins with a token that could continue the value before it.
bool needs_comma(const Tree& tree, const Names& names, NodeId before, NodeId id) {
    if (const auto* text = tree.get_if<node::Text>(id); text && is_verbatim(tree, *text))
        return false;
    const std::size_t kind_before = tree[before].content.index();
    const auto* chain = tree.get_if<node::Chain>(id);
    if (chain && tree.get_if<node::Joined>(chain->first)) return false;
    if (takes_value(tree, names, before)) return true;
    const bool directive = tree[id].content.index() >= kind<node::Declare>;
    if (directive || kind_before >= kind<node::Declare>)
        return kind_before >= kind<node::Declare> && !directive;
    if (tree.get_if<node::Block>(id)) return tree.get_if<node::Block>(before) != nullptr;
    const auto* word = tree.get_if<node::Word>(id);
    const bool channel_word = tree.get_if<node::Word>(before) && !tree.get_if<node::Entry>(id);
    return !(word && !channel_word);
}

/// Whether `( ... )` can hold these nodes: directives, then perhaps a value.
bool fits_parentheses(const Tree& tree, NodeId first) {
    NodeId last = first;
    while (last != no_node && tree[last].next != no_node) last = tree[last].next;
    return !tree.get_if<node::Block>(last) && !tree.get_if<node::Layers>(last) &&
           !tree.get_if<node::Array>(last) && !tree.get_if<node::Function>(last) &&
           !tree.get_if<node::Prefixed>(last) && !tree.get_if<node::Colour>(last);
}

struct Print {
    const Tree& tree;
    const Names& names;
    NodeId id;

    std::string spell(NameId name) const { return std::string(names.spelling(name)); }
    std::string number(std::uint32_t i) const {
        const double value = tree.numbers[i];
        return value > 1.7e308                     ? "1e999"
               : value < -1.7e308                  ? "-1e999"
               : std::signbit(value) && value == 0 ? "-0"
                                                   : message(value);
    }

    Pieces operator()(node::Broken) const { return {say("/* broken */")}; }
    Pieces operator()(const node::Number& n) const { return {say(number(n.number))}; }
    Pieces operator()(const node::Literal& n) const {
        std::string text = "<";
        for (std::uint32_t i = 0; i < n.count; ++i)
            text += message(i ? ", " : "", number(n.first_number + i));
        return {say(message(text, ">"))};
    }
    Pieces operator()(const node::Text& n) const {
        const std::string& text = tree.texts[n.text];
        return {say(is_verbatim(tree, n) ? message('"', text, '"') : quoted(text))};
    }
    Pieces operator()(const node::Name& n) const { return {say(spell(n.name))}; }
    Pieces operator()(const node::Word& n) const { return {say(spell(n.word))}; }
    Pieces operator()(const node::Constant& n) const { return {say(spell(n.word))}; }
    Pieces operator()(const node::Index& n) const {
        return {say(spell(n.name)), joined(n.indices)};
    }
    Pieces operator()(const node::Member& n) const {
        // A number would take the point as its own.
        const bool number = tree.get_if<node::Number>(n.operand);
        return {one(n.operand), say(message(number ? " ." : ".", spell(n.member)))};
    }
    Pieces operator()(const node::Call& n) const {
        return {say(message(spell(n.name), "(")), commas(n.arguments), say(")")};
    }
    Pieces operator()(const node::Apply& n) const {
        return {one(n.function), say("("), commas(n.arguments), say(")")};
    }
    Pieces operator()(const node::Unary& n) const {
        return {say(std::string(spelling(n.sign))), one(n.operand)};
    }
    Pieces operator()(const node::Binary& n) const {
        return {one(n.left), say(message(" ", spelling(n.sign), " ")), one(n.right)};
    }
    Pieces operator()(const node::Choice& n) const {
        return {one(n.condition), say(" ? "), one(n.yes), say(" : "), one(n.no)};
    }
    Pieces operator()(const node::Joined& n) const {
        return {say(message(spelling(n.sign), " ")), one(n.operand)};
    }
    Pieces operator()(const node::Chain& n) const { return {blanks(n.first)}; }
    Pieces operator()(node::Nothing) const { return {}; }
    Pieces operator()(node::Omitted) const { return {}; }
    Pieces operator()(const node::Group& n) const {
        if (!fits_parentheses(tree, n.content)) return {blanks(n.content)};
        return {say("("), blanks(n.content), say(")")};
    }
    Pieces operator()(const node::Tuple& n) const {
        return {say("("), commas(n.content), say(")")};
    }
    Pieces operator()(const node::Vector& n) const {
        return {say("<"), commas(n.components), say(">")};
    }
    Pieces operator()(const node::Prefixed& n) const {
        return {say(message(spell(n.prefix), " ")), one(n.operand)};
    }
    Pieces operator()(const node::Colour& n) const {
        if (n.base == no_node) return {say("color "), blanks(n.channels)};
        const bool prefixed = tree.get_if<node::Prefixed>(n.base) && n.channels != no_node;
        return {say(prefixed ? "" : "color "), one(n.base), say(n.channels == no_node ? "" : " "),
                blanks(n.channels)};
    }
    Pieces operator()(const node::Channel& n) const {
        return {say(message(spell(n.channel), " ")), one(n.operand)};
    }
    Pieces operator()(const node::Array& n) const {
        return {say(n.mixed ? "array mixed" : "array"), joined(n.sizes),
                say(n.content == no_node ? "" : " "), one(n.content)};
    }
    Pieces operator()(const node::Function& n) const {
        return {say("function "), commas(n.parameters), say(" { "), blanks(n.body), say(" }")};
    }
    Pieces operator()(const node::Block& n) const {
        return {say(message(spell(n.word), " {")), elements(n.body), say("}")};
    }
    Pieces operator()(const node::Layers& n) const { return {blanks(n.blocks)}; }
    Pieces operator()(const node::Entry& n) const { return {say("["), elements(n.body), say("]")}; }
    Pieces operator()(const node::Braces& n) const {
        if (n.optional) return {say("optional { "), commas(n.body), say(" }")};
        return {say("{"), elements(n.body), say("}")};
    }
    Pieces operator()(const node::Declare& n) const {
        return {say(n.local ? "#local " : "#declare "), one(n.target), say(" = "), one(n.value),
                say(n.semicolon ? ";" : "")};
    }
    Pieces operator()(const node::Deprecated& n) const {
        const auto& declare = tree.get<node::Declare>(n.declare);
        return {say(message(declare.local ? "#local" : "#declare", " deprecated ",
                            n.once ? "once " : "")),
                one(n.text),
                say(n.text == no_node ? "" : " "),
                one(declare.target),
                say(" = "),
                one(declare.value),
                say(declare.semicolon ? ";" : "")};
    }
    Pieces operator()(const node::Undef& n) const { return {say("#undef "), one(n.target)}; }
    Pieces operator()(const node::If& n) const {
        Pieces pieces;
        for (NodeId branch = n.branches; branch != no_node; branch = tree[branch].next) {
            const auto& part = tree.get<node::Branch>(branch);
            const bool first = branch == n.branches;
            if (const auto* test = tree.get_if<node::Defined>(part.condition)) {
                pieces.insert(pieces.end(), {say(test->negated ? "#ifndef (" : "#ifdef ("),
                                             one(test->target), say(")")});
            } else {
                pieces.insert(pieces.end(), {say(part.condition == no_node ? "#else"
                                                 : first                   ? "#if "
                                                                           : "#elseif "),
                                             one(part.condition)});
            }
            pieces.push_back(elements(part.body));
        }
        pieces.push_back(say("#end"));
        return pieces;
    }
    Pieces operator()(const node::Branch&) const { return {}; }
    Pieces operator()(node::Postponed) const { return (*this)(node::Broken()); }
    Pieces operator()(const node::Defined&) const { return {}; }
    Pieces operator()(const node::While& n) const {
        return {say("#while "), one(n.condition), elements(n.body), say("#end")};
    }
    Pieces operator()(const node::For& n) const {
        return {say("#for ("), one(n.target),    say(", "),  commas(n.range),
                say(")"),      elements(n.body), say("#end")};
    }
    Pieces operator()(const node::Switch& n) const {
        return {say("#switch "), one(n.subject), elements(n.opening), blanks(n.cases),
                say(" #end")};
    }
    Pieces operator()(const node::Case& n) const {
        if (n.values == no_node) return {say("#else"), elements(n.body)};
        if (tree[n.values].next == no_node) return {say("#case "), one(n.values), elements(n.body)};
        return {say("#range ("), commas(n.values), say(")"), elements(n.body)};
    }
    Pieces operator()(node::Break) const { return {say("#break")}; }
    Pieces operator()(const node::Macro& n) const {
        return {say(message("#macro ", spell(n.name), "(")), commas(n.parameters), say(")"),
                elements(n.body), say("#end")};
    }
    Pieces operator()(const node::Parameter& n) const {
        return {say(message(n.optional ? "optional " : "", spell(n.name),
                            n.contract == no_node ? "" : " ")),
                blanks(n.contract)};
    }
    Pieces operator()(const node::Kind& n) const {
        std::string text = spell(n.word);
        for (std::uint32_t i = 0; i < n.dimensions; ++i) text += "[]";
        return {say(text)};
    }
    Pieces operator()(const node::Bound& n) const {
        return {say(message(spelling(n.sign), " ")), one(n.value)};
    }
    Pieces operator()(const node::Include& n) const { return {say("#include "), one(n.file)}; }
    Pieces operator()(const node::Default& n) const {
        return {say("#default {"), elements(n.body), say("}")};
    }
    Pieces operator()(const node::Message& n) const {
        constexpr std::string_view words[] = {"#debug ", "#warning ", "#error ", "#render ",
                                              "#statistics "};
        return {say(std::string(words[static_cast<std::size_t>(n.kind)])), one(n.text)};
    }
    Pieces operator()(const node::Version& n) const {
        return {say(n.unofficial ? "#version unofficial " : "#version "), one(n.value), say(";")};
    }
    Pieces operator()(const node::Open& n) const {
        return {say(message("#fopen ", spell(n.file), " ")), one(n.path),
                say(message(" ", spell(n.mode)))};
    }
    Pieces operator()(const node::Close& n) const {
        return {say(message("#fclose ", spell(n.file)))};
    }
    Pieces operator()(const node::Read& n) const {
        return {say("#read ("), commas(n.content), say(")")};
    }
    Pieces operator()(const node::Write& n) const {
        return {say("#write ("), blanks(n.content), say(")")};
    }
};

/// Splits a list into pieces. Joined lists hold only numbers in brackets.
Pieces list_pieces(const Tree& tree, const Names& names, const Piece& piece, std::size_t depth) {
    using Kind = Piece::Kind;
    const std::string line = message("\n", std::string(4 * depth, ' '));
    Pieces pieces;
    NodeId before = no_node;
    for (NodeId id = piece.id; id != no_node; before = id, id = tree[id].next) {
        if (piece.kind == Kind::elements) {
            pieces.push_back(say(message(
                before != no_node && needs_comma(tree, names, before, id) ? "," : "", line)));
        } else if (before != no_node && piece.kind != Kind::joined) {
            pieces.push_back(say(piece.kind == Kind::commas ? ", " : " "));
        }
        if (piece.kind == Kind::joined) pieces.push_back(say("["));
        pieces.push_back(one(id));
        if (piece.kind == Kind::joined) pieces.push_back(say("]"));
    }
    if (piece.kind == Kind::elements)
        pieces.push_back(say(line.substr(0, line.size() - (depth > 0 ? 4 : 0))));
    return pieces;
}

}  // namespace

std::string print(const Tree& tree, const Names& names) {
    std::string result;
    std::size_t depth = 0;
    Pieces work = {{Piece::Kind::elements, {}, tree.first}};
    bool outermost = true;
    while (!work.empty()) {
        Piece piece = std::move(work.back());
        work.pop_back();
        if (piece.kind == Piece::Kind::leave) --depth;
        if (piece.kind == Piece::Kind::text) result += piece.text;
        if (piece.kind == Piece::Kind::elements && piece.id == no_node) result += ' ';
        if (piece.id == no_node) continue;
        const bool list = piece.kind != Piece::Kind::node;
        const bool deeper = piece.kind == Piece::Kind::elements && !outermost;
        if (deeper) ++depth;
        Pieces pieces = list ? list_pieces(tree, names, piece, depth)
                             : std::visit(Print{tree, names, piece.id}, tree[piece.id].content);
        if (deeper) pieces.push_back({Piece::Kind::leave, {}, no_node});
        outermost = false;
        std::move(pieces.rbegin(), pieces.rend(), std::back_inserter(work));
    }
    const std::size_t first = result.find_first_not_of('\n');
    return first == std::string::npos ? std::string() : result.substr(first);
}

}  // namespace candelabra
