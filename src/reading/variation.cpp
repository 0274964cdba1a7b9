// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/variation.h"

#include "reading/constants.h"
#include "reading/convert.h"
#include "reading/transforms.h"
#include "vocabulary/reserved.h"

#include <utility>

namespace candelabra {

namespace {

/// Whether walking the node has no effect but to yield its numbers, if it has any.
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

/// The index of a word among the fields of Moves, or -1.
int movement(const Tree& tree, NodeId id) {
    const auto* word = tree.get_if<node::Word>(id);
    if (!word) return -1;
    return word->word == "translate"_word ? 0
           : word->word == "rotate"_word  ? 1
           : word->word == "scale"_word   ? 2
                                          : -1;
}

bool moves(const Tree& tree, NodeId id) {
    if (const auto* word = tree.get_if<node::Word>(id))
        return movement(tree, id) >= 0 || word->word == "matrix"_word ||
               word->word == "transform"_word;
    const auto* block = tree.get_if<node::Block>(id);
    return block && block->word == "transform"_word;
}

/// The `rgb ...` of a pigment that contains nothing else, or no_node.
NodeId only_colour(const Tree& tree, NodeId id) {
    const auto* block = tree.get_if<node::Block>(id);
    const bool only = block && block->word == "pigment"_word && colour_alone({&tree, block->body});
    return only ? block->body : no_node;
}

}  // namespace

std::optional<Variable> Variable::find(Evaluator& evaluator, const Body& block,
                                       std::size_t values) {
    const Tree& tree = *block.tree;
    Variable result;
    NodeId id = block.first;
    for (; result.values_ < values; ++result.values_) {
        if (id == no_node || !is_expression(evaluator, tree, id)) return std::nullopt;
        id = tree[id].next;
    }
    return result.analyse(evaluator, tree, id) ? std::optional(result) : std::nullopt;
}

bool Variable::analyse(Evaluator& evaluator, const Tree& tree, NodeId first) {
    std::vector<NodeId> rest;
    for (NodeId id = first; id != no_node; id = tree[id].next) rest.push_back(id);
    std::size_t end = rest.size();
    bool varies = false;
    for (; end >= 2 && movement(tree, rest[end - 2]) >= 0; end -= 2) {
        if (!is_expression(evaluator, tree, rest[end - 1])) break;
        varies |= !is_constant(tree, rest[end - 1]);
    }
    if (varies) movements_ = rest[end];
    return take_rest(tree, first);
}

/// Analyses the elements before the transformations.
bool Variable::take_rest(const Tree& tree, NodeId first) {
    bool looks = false;
    for (NodeId id = first; id != movements_; id = tree[id].next) {
        if (moved() && moves(tree, id)) return false;
        const auto* block = tree.get_if<node::Block>(id);
        if (block && (block->word == "pigment"_word || block->word == "texture"_word ||
                      block->word == "material"_word)) {
            // One of two textures could cover the other.
            const bool first_look = !std::exchange(looks, true);
            if (coloured() || !take_look(tree, id) || (coloured() && !first_look)) return false;
        } else if (!is_constant_but_names(tree, id, names_)) {
            return false;
        }
    }
    return true;
}

bool Variable::take_look(const Tree& tree, NodeId id) {
    const auto varying = [&](NodeId pigment) {
        const NodeId colour = only_colour(tree, pigment);
        return colour != no_node && !is_constant(tree, colour) ? colour : no_node;
    };
    colour_ = varying(id);
    if (coloured()) return true;
    const auto& block = tree.get<node::Block>(id);
    const std::size_t names = names_.size();
    for (NodeId part = block.body; part != no_node && block.word == "texture"_word;
         part = tree[part].next) {
        if (const NodeId colour = varying(part); colour != no_node) {
            if (coloured()) return false;
            colour_ = colour;
            continue;
        }
        const auto* inner = tree.get_if<node::Block>(part);
        const bool fits = (inner && inner->word == "finish"_word) ||
                          (tree.get_if<node::Name>(part) && !coloured());
        if (!fits || !is_constant_but_names(tree, part, names_)) {
            colour_ = no_node;
            break;
        }
    }
    if (coloured()) return true;
    names_.resize(names);
    return is_constant_but_names(tree, id, names_);
}

bool Variable::compute(Evaluator& evaluator, const Body& block, Variation& result) const {
    Body at = block;
    for (; result.count < values_; at.first = (*block.tree)[at.first].next)
        if (!evaluator.compute(at, result.values[result.count++])) return false;
    if (coloured()) {
        const auto colour = computed_colour(evaluator, {block.tree, colour_});
        if (!colour) return false;
        result.colour = *colour;
    }
    return !moved() || compute_movement(evaluator, *block.tree, result.movement);
}

bool Variable::compute_movement(Evaluator& evaluator, const Tree& tree,
                                std::optional<Transform>& result) const {
    for (NodeId word = movements_; word != no_node;) {
        const NodeId value = tree[word].next;
        const int kind = movement(tree, word);
        Numbers numbers;
        Moves said;
        if (!evaluator.compute({&tree, value}, numbers) ||
            !set_fitting(Moves::vocabulary, &said, static_cast<std::size_t>(kind), numbers) ||
            said.scale.x * said.scale.y * said.scale.z == 0)
            return false;
        const Transform next = kind == 0   ? Transform::translation(said.translate)
                               : kind == 1 ? Transform::rotation(said.rotate)
                                           : Transform::scaling(said.scale);
        result = result ? result->then(next) : next;
        word = tree[value].next;
    }
    return true;
}

}  // namespace candelabra
