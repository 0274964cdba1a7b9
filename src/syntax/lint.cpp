// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/lint.h"

#include "text/message.h"

#include <unordered_map>

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

}  // namespace

void lint(const Tree& tree, const Names& names, Diagnostics& diagnostics) {
    std::unordered_map<NameId, NameId> scoped;
    for (const ScopedName& each : tree.scoped) scoped[each.whole] = each.name;
    std::unordered_map<NameId, std::size_t> last_use;  // by name: the last node that names it
    for (std::size_t end = 0; end < tree.nodes.size(); ++end) {
        const NameId used = name_in(tree.nodes[end].content);
        const auto other = scoped.find(used);
        if (used != no_name) last_use[other == scoped.end() ? used : other->second] = end;
        const auto* macro = std::get_if<node::Macro>(&tree.nodes[end].content);
        // A macro without a body is a placeholder.
        if (!macro || macro->body == no_node) continue;
        for (NodeId id = macro->parameters; id != no_node; id = tree[id].next) {
            const NameId name = tree.get<node::Parameter>(id).name;
            // A node follows its children in the array, so the body is between the two.
            const auto use = last_use.find(name);
            if (use != last_use.end() && use->second > static_cast<std::size_t>(id)) continue;
            diagnostics.add(
                warning(Fault::unused_parameter, tree.span(id),
                        message("macro `", names.spelling(macro->name),
                                "` does not use its parameter `", names.spelling(name), "`")));
        }
    }
}

}  // namespace candelabra
