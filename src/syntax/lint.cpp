// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lint.h"

#include "text/message.h"

#include <algorithm>

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

}  // namespace

void lint(const Tree& tree, const Names& names, Diagnostics& diagnostics) {
    for (std::size_t end = 0; end < tree.nodes.size(); ++end) {
        const auto* macro = std::get_if<node::Macro>(&tree.nodes[end].content);
        // One without a body stands for something that is to come.
        if (!macro || macro->body == no_node) continue;
        for (NodeId id = macro->parameters; id != no_node; id = tree[id].next) {
            const NameId name = tree.get<node::Parameter>(id).name;
            // A node lies behind those that it consists of: the body is between them.
            const auto first = tree.nodes.begin() + static_cast<std::ptrdiff_t>(id);
            const auto last = tree.nodes.begin() + static_cast<std::ptrdiff_t>(end);
            if (std::any_of(first, last,
                            [&](const Node& node) { return name_in(node.content) == name; }))
                continue;
            const std::string_view macro_name = names.spelling(macro->name);
            diagnostics.add(warning(Fault::unused_parameter, tree.span(id),
                                    message("macro `", macro_name, "` does not use its parameter `",
                                            names.spelling(name), "`")));
        }
    }
}
