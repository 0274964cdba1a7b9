// SPDX-License-Identifier: GPL-3.0-or-later
// #declare, #local, #undef, #macro.
#include "evaluate/state.h"
#include "text/message.h"

Value Evaluator::State::right_side(const Tree& tree, NodeId id) {
    const NodeContent& content = tree[id].content;
    if (const auto* layers = std::get_if<node::Layers>(&content)) {
        std::vector<Element> blocks;
        for (NodeId block = layers->blocks; block != no_node; block = tree[block].next)
            blocks.push_back(block_element(tree, block));
        return one_value(blocks, tree.span(id));
    }
    std::vector<Element> elements;
    walk_one(tree, id, [&](const Element& element) { elements.push_back(element); });
    return one_value(elements, tree.span(id));
}

void Evaluator::State::declare(const Tree& tree, const node::Declare& node, NodeId id) {
    if (tree.get_if<node::Tuple>(node.target)) return declare_tuple(tree, node, id);
    Value value = evaluate(tree, node.value);
    if (stopped_) return;
    if (value.numbers() && !node.semicolon) {
        const Span end{tree.source, tree[node.value].last, tree[node.value].last};
        const std::string text = "a `;` is missing after this value";
        Diagnostic problem = version >= 3.5 ? error(Fault::semicolon, end, text)
                                            : warning(Fault::semicolon, end, text);
        report(problem.with_help("#declare and #local of numbers, vectors and colours end in `;`"));
    }
    assign(tree, node.target, std::move(value), node.local);
}

/// `#declare (a, b) = (1, 2);`, one after the other.
void Evaluator::State::declare_tuple(const Tree& tree, const node::Declare& node, NodeId id) {
    const auto* values = tree.get_if<node::Tuple>(node.value);
    NodeId value = values ? values->content : no_node;
    NodeId target = tree.get<node::Tuple>(node.target).content;
    for (; target != no_node && value != no_node;
         target = tree[target].next, value = tree[value].next)
        assign(tree, target, evaluate(tree, value), node.local);
    if (target != no_node || value != no_node)
        broken(Fault::wrong_count, tree.span(id), "there must be as many values as names");
}

void Evaluator::State::assign(const Tree& tree, NodeId target, Value value, bool local) {
    const Span span = tree.span(target);
    if (const auto* name = tree.get_if<node::Name>(target)) {
        const Value* before = scope.find(name->name);
        if (before && before->handle<MacroData>()) {
            broken(Fault::redefinition, span,
                   message("`", names.spelling(name->name),
                           "` is a macro and cannot become something else"));
            return;
        }
        if (local)
            scope.declare_local(name->name, std::move(value));
        else
            scope.declare(name->name, std::move(value));
        return;
    }
    const auto* index = tree.get_if<node::Index>(target);
    if (!index) {
        broken(Fault::wrong_type, span, "this cannot be declared");
        return;
    }
    const std::optional<Indices> places = indices(tree, index->indices);
    if (!places) return;
    Value* array = scope.edit(index->name);
    if (!array) {
        unknown_name(index->name, span);
        return;
    }
    Value* element = edit_element(*array, *places, span);
    if (!element) return;
    if (const Value* other = other_element(*array, *places);
        other && !value.broken() && !other->same_kind(value)) {
        broken(Fault::wrong_type, span,
               message("all elements of an array are of one kind: others are ", kind_name(*other),
                       ", and this is ", kind_name(value)));
        return;
    }
    *element = std::move(value);
}

void Evaluator::State::undefine(const Tree& tree, NodeId target) {
    if (const auto* name = tree.get_if<node::Name>(target)) {
        if (!scope.undefine(name->name))
            report(warning(Fault::unknown_name, tree.span(target),
                           message("nothing is declared as `", names.spelling(name->name), "`")));
        return;
    }
    const auto& index = tree.get<node::Index>(target);
    const std::optional<Indices> places = indices(tree, index.indices);
    if (!places) return;
    Value* array = scope.edit(index.name);
    if (!array) {
        unknown_name(index.name, tree.span(target));
    } else if (Value* element = edit_element(*array, *places, tree.span(target))) {
        *element = Absence::uninitialised;
    }
}

void Evaluator::State::define_macro(const Tree& tree, const node::Macro& node, NodeId id) {
    const auto head = static_cast<std::uint32_t>(names.spelling(node.name).size());
    const Value* before = scope.find(node.name);
    if (before && !before->handle<MacroData>()) {
        broken(Fault::redefinition, tree.span(id),
               message("`", names.spelling(node.name), "` is declared as ", kind_name(*before),
                       " and cannot become a macro"));
        return;
    }
    MacroData macro{node.name, {&tree, node.parameters}, {&tree, node.body}, tree.span(id)};
    // The place of its first line; the whole macro may be long.
    const std::string_view text = sources.text(tree.source).substr(macro.defined.first);
    const std::size_t name = text.find(names.spelling(node.name));
    macro.defined.last =
        macro.defined.first +
        static_cast<std::uint32_t>(name == std::string_view::npos ? 0 : name + head);
    scope.declare(node.name, make_handle<MacroData>(macro));
}
