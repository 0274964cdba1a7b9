// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/shape_plans.h"

#include "reading/constants.h"
#include "vocabulary/item_info.h"

namespace candelabra {

namespace {

/// Number of values that a shape needs; nothing if some are not plain numbers or vectors.
std::optional<std::size_t> values_needed(const ItemInfo& item) {
    std::size_t count = 0;
    for (const FieldInfo& field : item.fields.first(static_cast<std::size_t>(item.positional))) {
        if (field.may_be_left_out) break;
        const bool plain = field.type == FieldType::number || field.type == FieldType::vector3;
        if (!plain || field.place != Placement::positional) return std::nullopt;
        ++count;
    }
    return count > 0 && count <= Variation::most ? std::optional(count) : std::nullopt;
}

/// Whether a plan can change all parts of the object: its texture, if any, is one colour.
bool simple(const Object& object) {
    return !object.clipping && !object.part_textures &&
           (!object.texture || object.texture->plain());
}

}  // namespace

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
    note_vain();
    return nullptr;
}

void ShapePlan::learn(const Evaluator& evaluator, const Handle<Texture>& default_texture,
                      const Variation& variation, const ObjectHandle& made) {
    // A shape without extent was replaced by an empty union.
    if (std::holds_alternative<Shape>(made->form) != shape_) return;
    const bool coloured = made->texture && made->texture->pigment.colour == variation.colour;
    if ((!variable_.plain() && !simple(*made)) || (variable_.coloured() && !coloured))
        return note_vain();
    for (Known& known : names_) {
        const Value* now = evaluator.find(known.name);
        known.value = now ? std::optional(*now) : std::nullopt;
    }
    default_texture_ = default_texture;
    model_ = made;
    if (variable_.moved()) model_.edit().transform = nullptr;
}

ShapePlan* ShapePlans::find(Evaluator& evaluator, const Element& block, const ItemInfo* item) {
    const auto [tree, node] = block.origin;
    if (!tree || (item && item->positional == 0)) return nullptr;
    if (tree->source >= nodes_.size()) nodes_.resize(tree->source + 1);
    std::vector<std::uint32_t>& nodes = nodes_[tree->source];
    if (nodes.empty()) nodes.resize(tree->nodes.size());
    std::uint32_t& known = nodes[static_cast<std::size_t>(node)];
    if (known >= planned) {
        ShapePlan& plan = plans_[known - planned];
        return plan.promising() ? &plan : nullptr;
    }
    const std::uint32_t before = std::exchange(known, known == 0 ? met : hopeless);
    if (before != met || is_constant(*tree, node)) return nullptr;
    const std::optional<std::size_t> values = item ? values_needed(*item) : 0;
    std::optional<Variable> variable =
        values ? Variable::find(evaluator, block.body, *values) : std::nullopt;
    if (!variable || (!item && variable->plain())) return nullptr;
    known = static_cast<std::uint32_t>(planned + plans_.size());
    return &plans_.emplace_back(std::move(*variable), item != nullptr);
}

}  // namespace candelabra
