// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of functions and macros.
#include "evaluate/state.h"
#include "text/message.h"

namespace {

std::size_t list_length(const Tree& tree, NodeId first) {
    std::size_t count = 0;
    for (NodeId id = first; id != no_node; id = tree[id].next) ++count;
    return count;
}

}  // namespace

Value Evaluator::State::call(const Tree& tree, const node::Call& node, NodeId id) {
    if (names.reserved(node.name)) return call_function(tree, node, id);
    std::vector<Element> elements;
    // A block is computed before the macro is left, while the macro's names are there.
    call_macro(tree, node, id, [&](const Element& element) {
        elements.push_back(element);
        if (element.kind != Element::Kind::block) return;
        elements.back().value = meaning.value({&element, 1});
        elements.back().kind = Element::Kind::value;
    });
    return one_value(elements, tree.span(id));
}

bool Evaluator::State::defined(const Tree& tree, NodeId target) {
    if (const auto* name = tree.get_if<node::Name>(target)) {
        const Value* found = scope.find(name->name);
        return found != nullptr;
    }
    const auto* index = tree.get_if<node::Index>(target);
    if (!index) return false;
    const std::optional<Indices> places = indices(tree, index->indices);
    const Value* array = scope.find(index->name);
    if (!places || !array) return false;
    const Value* found = element(*array, *places, tree.span(target));
    return found && !found->is(Absence::uninitialised);
}

Value Evaluator::State::call_function(const Tree& tree, const node::Call& node, NodeId id) {
    const FunctionInfo* function = functions[static_cast<std::size_t>(node.name)];
    const std::string_view name = names.spelling(node.name);
    if (!function && name == "defined") {
        if (list_length(tree, node.arguments) != 1)
            return broken(Fault::wrong_count, tree.span(id), "`defined` takes one name");
        return defined(tree, node.arguments) ? 1.0 : 0.0;
    }
    if (!function)
        return broken(Fault::not_implemented, tree.span(id),
                      message("`", name, "` is known but not implemented"));

    const auto* unary = std::get_if<FunctionInfo::Unary>(&function->code);
    if (unary && node.arguments != no_node && tree[node.arguments].next == no_node &&
        !tree.get_if<node::If>(node.arguments)) {
        const std::optional<double> argument =
            number(tree, node.arguments, "the argument of", node.name);
        return argument ? Value((*unary)(*argument)) : Value(Absence::broken);
    }
    std::vector<Value> values;
    std::vector<Span> places;
    bool good = true;
    walk_arguments(tree, node.arguments, [&](Value value, Span place) {
        good = good && !value.broken();
        values.push_back(std::move(value));
        places.push_back(place);
    });
    if (!good || stopped_) return Absence::broken;
    const auto count = static_cast<int>(values.size());
    if (count < function->least || count > function->most) {
        report(
            error(Fault::wrong_count, tree.span(id),
                  message("`", name, "` takes ",
                          function->most == FunctionInfo::any ? "at least " : "", function->least,
                          function->most > function->least && function->most != FunctionInfo::any
                              ? message(" or ", function->most)
                              : "",
                          function->least == 1 &&
                                  (function->most == 1 || function->most == FunctionInfo::any)
                              ? " argument"
                              : " arguments",
                          ", but here ", count == 1 ? "is " : "are ", count))
                .with_help(message(name, "(", function->arguments, "): ", function->help)));
        if (diagnostics.full()) stopped_ = true;
        return Absence::broken;
    }
    FunctionCall call(name, values, places, tree.span(id), world);
    Value result = unary ? Value((*unary)(call.number(0)))
                         : (*std::get_if<FunctionInfo::General>(&function->code))(call);
    if (call.failed()) return Absence::broken;
    if (call.given()) receive(tree, node.arguments, count, *call.given());
    return result;
}

/// Stores a function's second result in the variable that its last argument is.
void Evaluator::State::receive(const Tree& tree, NodeId first, int count, const Value& value) {
    NodeId last = first;
    while (tree[last].next != no_node) last = tree[last].next;
    if (static_cast<int>(list_length(tree, first)) == count &&
        (tree.get_if<node::Name>(last) || tree.get_if<node::Index>(last))) {
        assign(tree, last, value, false);
        return;
    }
    report(error(Fault::wrong_type, tree.span(last), "here must be the name of a declared vector")
               .with_help("trace(object, from, direction, Normal) stores the normal in `Normal`"));
}

/// Arguments of a function: values, and directives between them.
void Evaluator::State::walk_arguments(const Tree& tree, NodeId first,
                                      FunctionRef<void(Value, Span)> take) {
    for (NodeId id = first; id != no_node && !stopped_; id = tree[id].next) {
        if (is_directive(tree, id)) {
            walk_one(tree, id, [&](const Element& element) {
                take(evaluator.value_of(element), element.span);
            });
        } else {
            take(evaluate(tree, id), tree.span(id));
        }
    }
}

bool Evaluator::State::argument(const Tree& tree, NodeId id, Argument& result) {
    if (const auto* name = tree.get_if<node::Name>(id)) {
        const Value* found = scope.find(name->name);
        if (found && !found->absent() && !found->handle<MacroData>()) {
            result.reference = scope.reference(name->name);
            return true;
        }
    } else if (const auto* index = tree.get_if<node::Index>(id)) {
        const std::optional<Indices> places = indices(tree, index->indices);
        if (!places) return false;
        if (Value* array = scope.edit(index->name)) {
            std::size_t used = 0;
            if (!check_array(*array, tree.span(id))) return false;
            const std::optional<std::size_t> i =
                place(*array->array(), *places, used, tree.span(id));
            if (!i) return false;
            const Scope::Reference base = scope.reference(index->name);
            if (used == places->count && base.element < 0 &&
                !array->array()->elements[*i].absent()) {
                result.reference = {base.cell, static_cast<std::int64_t>(*i)};
                return true;
            }
        }
    }
    result.value = evaluate(tree, id);
    return !result.value.broken();
}

std::optional<std::vector<Evaluator::State::Argument>> Evaluator::State::arguments(
    const Tree& tree, const node::Call& node, NodeId id, const MacroData& macro) {
    std::vector<Argument> result;
    bool good = true;
    for (NodeId argument = node.arguments; argument != no_node && !stopped_;
         argument = tree[argument].next)
        good = this->argument(tree, argument, result.emplace_back()) && good;
    if (!good || stopped_) return std::nullopt;

    const Tree& origin = *macro.parameters.tree;
    std::size_t least = 0, most = 0;
    std::string list;
    for (NodeId parameter = macro.parameters.first; parameter != no_node;
         parameter = origin[parameter].next, ++most) {
        const auto& info = origin.get<node::Parameter>(parameter);
        if (!info.optional) least = most + 1;
        list += message(most > 0 ? ", " : "", info.optional ? "optional " : "",
                        names.spelling(info.name));
    }
    if (result.size() < least || result.size() > most) {
        report(error(Fault::wrong_count, tree.span(id),
                     message("macro `", names.spelling(macro.name), "` takes ",
                             least == most ? message(most) : message(least, " to ", most),
                             most == 1 ? " argument" : " arguments", ", but here ",
                             result.size() == 1 ? "is " : "are ", result.size()))
                   .pointing(macro.defined,
                             message("defined as ", names.spelling(macro.name), "(", list, ")")));
        if (diagnostics.full()) stopped_ = true;
        return std::nullopt;
    }
    return result;
}

Flow Evaluator::State::call_macro(const Tree& tree, const node::Call& node, NodeId id, Take take) {
    if (!room(tree, id)) return Flow::stopped;
    const auto emit_broken = [&] {
        Element element;
        element.kind = Element::Kind::value;
        element.value = Absence::broken;
        element.span = element.word_span = tree.span(id);
        take(element);
        return stopped_ ? Flow::stopped : Flow::end;
    };
    const Value* found = scope.find(node.name);
    if (!found) {
        unknown_name(node.name, {tree.source, tree[id].first,
                                 tree[id].first +
                                     static_cast<std::uint32_t>(names.spelling(node.name).size())});
        return emit_broken();
    }
    const Handle<MacroData> macro = found->handle<MacroData>();
    if (!macro) {
        if (!found->broken())
            broken(Fault::wrong_type, tree.span(id),
                   message("`", names.spelling(node.name), "` is ", kind_name(*found),
                           " and cannot be called"));
        return emit_broken();
    }
    if (too_many_steps(tree.span(id))) return Flow::stopped;
    if (frames.depth() >= limits.call_depth) {
        if (!stopped_)
            report(error(Fault::recursion_limit, tree.span(id),
                         message("macros call each other ", limits.call_depth,
                                 " deep, which is the limit"))
                       .with_help("a recursion needs an #if that ends it; --limit-depth raises the "
                                  "limit"));
        stopped_ = true;
        return Flow::stopped;
    }
    std::optional<std::vector<Argument>> values = arguments(tree, node, id, *macro);
    if (!values) return emit_broken();
    scope.enter();
    NodeId parameter = macro->parameters.first;
    for (Argument& argument : *values) {
        const NameId name = macro->parameters.tree->get<node::Parameter>(parameter).name;
        if (argument.reference.cell)
            scope.alias(name, argument.reference);
        else
            scope.bind_parameter(name, std::move(argument.value));
        parameter = (*macro->parameters.tree)[parameter].next;
    }
    values.reset();
    frames.push({Frame::macro, macro->name, {}, tree.span(id)});
    const Flow flow = walk(*macro->body.tree, macro->body.first, take);
    frames.pop();
    scope.leave();
    return flow == Flow::stopped ? Flow::stopped
                                 : Flow::end;  // a #break outside loops ends the macro
}
