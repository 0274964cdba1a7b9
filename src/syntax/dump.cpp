// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/dump.h"

#include "syntax/lexer.h"
#include "syntax/quoted.h"
#include "text/message.h"
#include "text/utf8.h"

#include <algorithm>

namespace candelabra {

namespace {

/// A node for dump(): its description, and the lists below it.
struct Description {
    std::string text;
    std::vector<std::pair<std::string_view, NodeId>> lists;
};

struct Describe {
    const Tree& tree;
    const Names& names;

    std::string spell(NameId name) const { return std::string(names.spelling(name)); }

    Description operator()(node::Broken) const { return {"broken", {}}; }
    Description operator()(const node::Number& n) const {
        return {message("number ", tree.numbers[n.number]), {}};
    }
    Description operator()(const node::Literal& n) const {
        std::string text = "literal";
        for (std::uint32_t i = 0; i < n.count; ++i)
            text += message(" ", tree.numbers[n.first_number + i]);
        return {text, {}};
    }
    Description operator()(const node::Text& n) const {
        return {message("text ", quoted(tree.texts[n.text])), {}};
    }
    Description operator()(const node::Name& n) const {
        return {message("name ", spell(n.name)), {}};
    }
    Description operator()(const node::Word& n) const {
        return {message("word ", spell(n.word)), {}};
    }
    Description operator()(const node::Constant& n) const {
        return {message("constant ", spell(n.word)), {}};
    }
    Description operator()(const node::Index& n) const {
        return {message("index ", spell(n.name)), {{"at", n.indices}}};
    }
    Description operator()(const node::Member& n) const {
        return {message("member ", spell(n.member)), {{"of", n.operand}}};
    }
    Description operator()(const node::Call& n) const {
        return {message("call ", spell(n.name)), {{"with", n.arguments}}};
    }
    Description operator()(const node::Apply& n) const {
        return {"apply", {{"function", n.function}, {"with", n.arguments}}};
    }
    Description operator()(const node::Unary& n) const {
        return {message("unary ", spelling(n.sign)), {{"", n.operand}}};
    }
    Description operator()(const node::Binary& n) const {
        return {message("binary ", spelling(n.sign)), {{"left", n.left}, {"right", n.right}}};
    }
    Description operator()(const node::Choice& n) const {
        return {"choice", {{"if", n.condition}, {"then", n.yes}, {"else", n.no}}};
    }
    Description operator()(const node::Joined& n) const {
        return {message("joined ", spelling(n.sign)), {{"", n.operand}}};
    }
    Description operator()(const node::Chain& n) const { return {"chain", {{"", n.first}}}; }
    Description operator()(node::Nothing) const { return {"nothing", {}}; }
    Description operator()(node::Omitted) const { return {"omitted", {}}; }
    Description operator()(const node::Group& n) const { return {"group", {{"", n.content}}}; }
    Description operator()(const node::Tuple& n) const { return {"tuple", {{"", n.content}}}; }
    Description operator()(const node::Vector& n) const { return {"vector", {{"", n.components}}}; }
    Description operator()(const node::Prefixed& n) const {
        return {spell(n.prefix), {{"", n.operand}}};
    }
    Description operator()(const node::Colour& n) const {
        return {"colour", {{"base", n.base}, {"channels", n.channels}}};
    }
    Description operator()(const node::Channel& n) const {
        return {message("channel ", spell(n.channel)), {{"", n.operand}}};
    }
    Description operator()(const node::Array& n) const {
        return {n.mixed ? "mixed array" : "array", {{"sizes", n.sizes}, {"content", n.content}}};
    }
    Description operator()(const node::Function& n) const {
        return {"function", {{"parameters", n.parameters}, {"body", n.body}}};
    }
    Description operator()(const node::Block& n) const {
        return {message("block ", spell(n.word)), {{"", n.body}}};
    }
    Description operator()(const node::Layers& n) const { return {"layers", {{"", n.blocks}}}; }
    Description operator()(const node::Entry& n) const { return {"entry", {{"", n.body}}}; }
    Description operator()(const node::Braces& n) const {
        return {n.optional ? "optional braces" : "braces", {{"", n.body}}};
    }
    Description operator()(const node::Declare& n) const {
        return {message(n.local ? "#local" : "#declare", n.semicolon ? " with ;" : ""),
                {{"target", n.target}, {"value", n.value}}};
    }
    Description operator()(const node::Deprecated& n) const {
        return {n.once ? "deprecated once" : "deprecated", {{"message", n.text}, {"", n.declare}}};
    }
    Description operator()(const node::Undef& n) const { return {"#undef", {{"", n.target}}}; }
    Description operator()(const node::If& n) const { return {"#if", {{"", n.branches}}}; }
    Description operator()(const node::Branch& n) const {
        return {n.condition == no_node ? "else" : "branch",
                {{"condition", n.condition}, {"body", n.body}}};
    }
    Description operator()(node::Postponed) const { return {"postponed", {}}; }
    Description operator()(const node::Defined& n) const {
        return {n.negated ? "not defined" : "defined", {{"", n.target}}};
    }
    Description operator()(const node::While& n) const {
        return {"#while", {{"condition", n.condition}, {"body", n.body}}};
    }
    Description operator()(const node::For& n) const {
        return {"#for", {{"counter", n.target}, {"range", n.range}, {"body", n.body}}};
    }
    Description operator()(const node::Switch& n) const {
        return {"#switch", {{"subject", n.subject}, {"opening", n.opening}, {"", n.cases}}};
    }
    Description operator()(const node::Case& n) const {
        return {n.values == no_node ? "else" : "case", {{"values", n.values}, {"body", n.body}}};
    }
    Description operator()(node::Break) const { return {"#break", {}}; }
    Description operator()(const node::Macro& n) const {
        return {message("#macro ", spell(n.name)),
                {{"parameters", n.parameters}, {"body", n.body}}};
    }
    Description operator()(const node::Parameter& n) const {
        return {message("parameter ", spell(n.name), n.optional ? ", optional" : ""),
                {{"contract", n.contract}}};
    }
    Description operator()(const node::Kind& n) const {
        return {n.dimensions == 0 ? message("kind ", spell(n.word))
                                  : message("kind ", spell(n.word), " of ", n.dimensions,
                                            n.dimensions == 1 ? " dimension" : " dimensions"),
                {}};
    }
    Description operator()(const node::Bound& n) const {
        return {message("bound ", spelling(n.sign)), {{"", n.value}}};
    }
    Description operator()(const node::Include& n) const { return {"#include", {{"", n.file}}}; }
    Description operator()(const node::Default& n) const { return {"#default", {{"", n.body}}}; }
    Description operator()(const node::Message& n) const {
        constexpr std::string_view words[] = {"#debug", "#warning", "#error", "#render",
                                              "#statistics"};
        return {std::string(words[static_cast<std::size_t>(n.kind)]), {{"", n.text}}};
    }
    Description operator()(const node::Version& n) const {
        return {n.unofficial ? "#version unofficial" : "#version", {{"", n.value}}};
    }
    Description operator()(const node::Open& n) const {
        return {message("#fopen ", spell(n.file), " ", spell(n.mode)), {{"", n.path}}};
    }
    Description operator()(const node::Close& n) const {
        return {message("#fclose ", spell(n.file)), {}};
    }
    Description operator()(const node::Read& n) const { return {"#read", {{"", n.content}}}; }
    Description operator()(const node::Write& n) const { return {"#write", {{"", n.content}}}; }
};

/// Blanks for the depth. Depths beyond any reader's use are written as a number: blanks would take
/// more room than a disk has.
std::string indentation(std::size_t depth) {
    constexpr std::size_t deepest = 100;
    if (depth <= deepest) return std::string(2 * depth, ' ');
    return message(std::string(2 * deepest, ' '), "(", depth, " deep) ");
}

}  // namespace

std::string dump(const Tree& tree, const Names& names) {
    struct Line {
        std::size_t depth;
        std::string_view label;
        NodeId id;
    };
    std::string result;
    std::vector<Line> work;
    const auto push = [&](std::size_t depth, std::string_view label, NodeId first) {
        const std::size_t start = work.size();
        for (NodeId id = first; id != no_node; id = tree[id].next)
            work.push_back({depth, label, id});
        std::reverse(work.begin() + static_cast<std::ptrdiff_t>(start), work.end());
    };
    push(0, "", tree.first);
    while (!work.empty()) {
        const Line line = work.back();
        work.pop_back();
        const Description description = std::visit(Describe{tree, names}, tree[line.id].content);
        result += message(indentation(line.depth), line.label, line.label.empty() ? "" : ": ",
                          description.text, "\n");
        for (std::size_t i = description.lists.size(); i-- > 0;)
            push(line.depth + 1, description.lists[i].first, description.lists[i].second);
    }
    return result;
}

std::string dump_tokens(SourceId source, const SourceStore& sources, Names& names,
                        Diagnostics& diagnostics) {
    Tree tree;
    tree.source = source;
    Lexer lexer(source, sources, names, tree, diagnostics);
    std::string result;
    const std::string_view text = sources.text(source);
    Place place;
    std::uint32_t at = 0;  // offset of `place`; 0 at first
    for (Token token = lexer.next(); token.kind != TokenKind::end_of_file; token = lexer.next()) {
        // A line may be as long as the file, so its characters are counted only once.
        const std::string_view between = text.substr(at, token.first - at);
        if (at == 0 || between.find_first_of("\r\n") != between.npos)
            place = sources.place(source, token.first);
        else
            place.column += static_cast<int>(character_count(between));
        at = token.first;
        result += message(place.line, ":", place.column, " ", name(token.kind), " ",
                          text.substr(token.first, token.last - token.first), "\n");
    }
    return result;
}

}  // namespace candelabra
