// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/constants.h"

#include "vocabulary/reserved.h"

namespace candelabra {

namespace {

/// Bounds the work for nested blocks, which are searched once for each enclosing block.
constexpr int max_nodes = 200;

class Search {
public:
    /// `names` collects the names on which the meaning depends; null: names are not constant.
    explicit Search(const Tree& tree, std::vector<NameId>* names = nullptr)
        : tree_(tree), names_(names) {}

    bool constant(NodeId id) {
        if (id == no_node) return true;
        if (++count_ > max_nodes) return false;
        return std::visit([&](const auto& content) { return holds(content); }, tree_[id].content);
    }

    bool all(NodeId first) {
        for (NodeId id = first; id != no_node; id = tree_[id].next)
            if (!constant(id)) return false;
        return true;
    }

private:
    bool holds(const node::Number&) { return true; }
    bool holds(const node::Literal&) { return true; }
    bool holds(const node::Text&) { return true; }
    bool holds(const node::Word&) { return true; }
    bool holds(const node::Constant& c) { return c.word != "now"_word && c.word != "version"_word; }
    bool holds(const node::Member& member) { return constant(member.operand); }
    bool holds(const node::Unary& unary) { return constant(unary.operand); }
    bool holds(const node::Binary& b) { return constant(b.left) && constant(b.right); }
    bool holds(const node::Choice& c) {
        return constant(c.condition) && constant(c.yes) && constant(c.no);
    }
    bool holds(const node::Group& group) { return all(group.content); }
    bool holds(const node::Vector& vector) { return all(vector.components); }
    bool holds(const node::Prefixed& prefixed) { return constant(prefixed.operand); }
    bool holds(const node::Colour& c) { return constant(c.base) && all(c.channels); }
    bool holds(const node::Channel& channel) { return constant(channel.operand); }
    bool holds(const node::Block& block) { return all(block.body); }
    bool holds(const node::Layers& layers) { return all(layers.blocks); }
    bool holds(const node::Entry& entry) { return all(entry.body); }
    bool holds(const node::Braces& braces) { return all(braces.body); }
    bool holds(const node::Name& name) {
        if (names_) names_->push_back(name.name);
        return names_ != nullptr;
    }
    /// Calls and directives may have another meaning the next time.
    bool holds(const auto&) { return false; }

    const Tree& tree_;
    std::vector<NameId>* names_;
    int count_ = 0;
};

}  // namespace

bool is_constant(const Tree& tree, NodeId id) { return Search(tree).constant(id); }
bool is_constant_but_names(const Tree& tree, NodeId id, std::vector<NameId>& names) {
    return Search(tree, &names).constant(id);
}

std::optional<std::uint64_t> Constants::number(const Element& element) {
    const auto [tree, node] = element.origin;
    if (!tree) return std::nullopt;
    if (tree->source >= nodes_.size()) nodes_.resize(tree->source + 1);
    std::vector<Known>& nodes = nodes_[tree->source];
    if (nodes.empty()) nodes.resize(tree->nodes.size());
    Known& known = nodes[static_cast<std::size_t>(node)];
    if (known == Known::met)
        known = is_constant(*tree, node) ? Known::constant : Known::variable;
    else if (known == Known::nothing)
        known = Known::met;
    if (known != Known::constant) return std::nullopt;
    return std::uint64_t{tree->source} << 32 | static_cast<std::uint32_t>(node);
}

}  // namespace candelabra
