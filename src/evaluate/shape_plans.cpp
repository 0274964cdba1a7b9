// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/shape_plans.h"

#include "evaluate/constants.h"
#include "vocabulary/item_info.h"

namespace {

/// A model that is out of date so much more often than not is not worth keeping.
constexpr int most_vain = 8;

/// Whether walking the node would do no more than hand on its numbers, if it has some.
bool is_expression(Evaluator& evaluator, const Tree& tree, NodeId id) {
    if (tree.get_if<node::Channel>(tree[id].next)) return false;
    switch (tree[id].content.index()) {
        case kind<node::Number>:
        case kind<node::Literal>:
        case kind<node::Name>:
        case kind<node::Constant>:
        case kind<node::Index>:
        case kind<node::Member>:
        case kind<node::Unary>:
        case kind<node::Binary>:
        case kind<node::Group>:
        case kind<node::Vector>:
            return true;
        case kind<node::Call>:
            return evaluator.names().reserved(tree.get<node::Call>(id).name);
        default:
            return false;
    }
}

/// How many values a shape needs; 0 when some of them are not plain numbers and vectors.
std::size_t values_needed(const ItemInfo& item) {
    std::size_t count = 0;
    for (const FieldInfo& field : item.fields.first(static_cast<std::size_t>(item.positional))) {
        if (field.may_be_left_out) break;
        const bool plain = field.type == FieldType::number || field.type == FieldType::vector3;
        if (!plain || field.place != Placement::positional) return 0;
        ++count;
    }
    return count <= LeadingValues::most ? count : 0;
}

}  // namespace

bool ShapePlan::analysable(Evaluator& evaluator, const Body& block, std::size_t values) {
    NodeId id = block.first;
    for (std::size_t i = 0; i < values; ++i) {
        if (id == no_node || !is_expression(evaluator, *block.tree, id)) return false;
        id = (*block.tree)[id].next;
    }
    return true;
}

ShapePlan::ShapePlan(const Body& block, std::size_t values) : values_(values) {
    NodeId rest = block.first;
    for (std::size_t i = 0; i < values; ++i) rest = (*block.tree)[rest].next;
    std::vector<NameId> names;
    repeatable_ = is_constant_but_names(*block.tree, rest, names);
    for (const NameId name : names) names_.push_back({name, std::nullopt});
}

LeadingValues ShapePlan::compute(Evaluator& evaluator, const Body& block) const {
    LeadingValues result;
    result.rest = block;
    while (result.count < values_) {
        if (!evaluator.compute(result.rest, result.numbers[result.count])) break;
        result.nodes[result.count++] = result.rest.first;
        result.rest.first = (*block.tree)[result.rest.first].next;
    }
    return result;
}

bool ShapePlan::unchanged(const Evaluator& evaluator) const {
    for (const Known& known : names_) {
        const Value* now = evaluator.find(known.name);
        if (known.value ? !now || !now->identical(*known.value) : now != nullptr) return false;
    }
    return true;
}

const Object* ShapePlan::model(const Evaluator& evaluator, const Handle<Texture>& default_texture) {
    if (!model_) return nullptr;
    if (default_texture == default_texture_ && unchanged(evaluator)) {
        if (vain_ > 0) --vain_;
        return model_.get();
    }
    model_ = nullptr;
    if (++vain_ > most_vain) repeatable_ = false;
    return nullptr;
}

void ShapePlan::learn(const Evaluator& evaluator, const Handle<Texture>& default_texture,
                      const ObjectHandle& made) {
    if (!repeatable_ || !std::holds_alternative<Shape>(made->form)) return;
    for (Known& known : names_) {
        const Value* now = evaluator.find(known.name);
        known.value = now ? std::optional(*now) : std::nullopt;
    }
    default_texture_ = default_texture;
    model_ = made;
}

ShapePlan* ShapePlans::find(Evaluator& evaluator, const Element& block, const ItemInfo& item) {
    const auto [tree, node] = block.origin;
    if (!tree || item.positional == 0) return nullptr;
    if (tree->source >= nodes_.size()) nodes_.resize(tree->source + 1);
    std::vector<std::uint32_t>& nodes = nodes_[tree->source];
    if (nodes.empty()) nodes.resize(tree->nodes.size());
    std::uint32_t& known = nodes[static_cast<std::size_t>(node)];
    if (known >= planned) return &plans_[known - planned];
    const std::uint32_t before = std::exchange(known, known == 0 ? met : hopeless);
    if (before != met) return nullptr;
    const std::size_t values = values_needed(item);
    if (values == 0 || !ShapePlan::analysable(evaluator, block.body, values) ||
        is_constant(*tree, node))
        return nullptr;
    known = static_cast<std::uint32_t>(planned + plans_.size());
    return &plans_.emplace_back(block.body, values);
}
