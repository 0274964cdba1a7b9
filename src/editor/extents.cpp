// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/extents.h"

#include "syntax/parser.h"
#include "syntax/token_classes.h"

#include <algorithm>
#include <unordered_map>

namespace candelabra {

namespace {

bool declares(const Tree& tree, NodeId id) {
    return tree.get_if<node::Declare>(id) || tree.get_if<node::Macro>(id) ||
           tree.get_if<node::For>(id) || tree.get_if<node::Open>(id) || tree.get_if<node::Read>(id);
}

/// Maps the beginnings of the directives in the parsed text to their ends.
std::unordered_map<std::uint32_t, std::uint32_t> directive_ends(const std::string& text) {
    SourceStore sources;
    Names names;
    Diagnostics ignored;
    const SourceId source = sources.add("", text);
    const Tree tree = parse(source, sources, names, ignored, {.included = true});
    std::unordered_map<std::uint32_t, std::uint32_t> ends;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (declares(tree, NodeId(i))) ends.emplace(tree.nodes[i].first, tree.nodes[i].last);
    return ends;
}

/// Does the same for macros, from tokens alone: macros with unbalanced braces are not in the tree.
std::unordered_map<std::uint32_t, std::uint32_t> macro_ends(const std::vector<Token>& tokens) {
    std::vector<const Token*> open;
    std::unordered_map<std::uint32_t, std::uint32_t> ends;
    for (const Token& token : tokens) {
        if (opens_directive(token.kind)) open.push_back(&token);
        if (token.kind != TokenKind::hash_end || open.empty()) continue;
        if (open.back()->kind == TokenKind::hash_macro)
            ends.emplace(open.back()->first, token.last);
        open.pop_back();
    }
    return ends;
}

/// Returns, for each token, the beginning of the last directive at or before it.
std::vector<std::uint32_t> directive_begins(const std::vector<Token>& tokens) {
    std::vector<std::uint32_t> begins;
    std::uint32_t last = 0;
    for (const Token& token : tokens)
        begins.push_back(last = is_directive(token.kind) ? token.first : last);
    return begins;
}

}  // namespace

std::vector<Part> extents(const EditedFile& file) {
    const auto ends = directive_ends(file.text);
    const auto macros = macro_ends(file.tokens);
    const auto begins = directive_begins(file.tokens);
    std::vector<Part> found;
    for (const DeclaredName& each : file.declarations) {
        const auto token =
            std::ranges::lower_bound(file.tokens, each.place.first, {}, &Token::first);
        const std::uint32_t first = begins[static_cast<std::size_t>(token - file.tokens.begin())];
        std::uint32_t last = each.place.last;
        for (const auto* known : {&ends, &macros})
            if (const auto end = known->find(first); end != known->end())
                last = std::max(last, end->second);
        found.push_back({first, last});
    }
    return found;
}

}  // namespace candelabra
