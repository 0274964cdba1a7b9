// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lint.h"

#include "text/message.h"

#include <algorithm>

namespace candelabra {

namespace {

/// The name that a node stands for or calls, if any.
NameId name_in(const NodeContent& content) {
    if (const auto* name = std::get_if<node::Name>(&content)) return name->name;
    if (const auto* index = std::get_if<node::Index>(&content)) return index->name;
    if (const auto* call = std::get_if<node::Call>(&content)) return call->name;
    if (const auto* block = std::get_if<node::Block>(&content)) return block->word;
    if (const auto* open = std::get_if<node::Open>(&content)) return open->file;
    if (const auto* close = std::get_if<node::Close>(&content)) return close->file;
    return no_name;
}

/// Whether a node from `first` on, up to the macro at `end`, names the parameter.
bool is_used(const Tree& tree, NodeId first, std::size_t end, NameId parameter) {
    const auto begin = tree.nodes.begin() + static_cast<std::ptrdiff_t>(first);
    const auto last = tree.nodes.begin() + static_cast<std::ptrdiff_t>(end);
    return std::any_of(begin, last,
                       [&](const Node& node) { return name_in(node.content) == parameter; });
}

}  // namespace

void lint(const Tree& tree, const Names& names, Diagnostics& diagnostics) {
    for (std::size_t end = 0; end < tree.nodes.size(); ++end) {
        const auto* macro = std::get_if<node::Macro>(&tree.nodes[end].content);
        // A macro without a body is a placeholder.
        if (!macro || macro->body == no_node) continue;
        for (NodeId id = macro->parameters; id != no_node; id = tree[id].next) {
            const NameId name = tree.get<node::Parameter>(id).name;
            // A node follows its children in the array, so the body is between the two.
            if (is_used(tree, id, end, name)) continue;
            diagnostics.add(
                warning(Fault::unused_parameter, tree.span(id),
                        message("macro `", names.spelling(macro->name),
                                "` does not use its parameter `", names.spelling(name), "`")));
        }
    }
}

}  // namespace candelabra
