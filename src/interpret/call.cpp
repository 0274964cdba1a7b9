// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of functions and macros.
#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "text/message.h"

namespace candelabra {

namespace {

std::size_t list_length(const Tree& tree, NodeId first) {
    std::size_t count = 0;
    for (NodeId id = first; id != no_node; id = tree[id].next) ++count;
    return count;
}

}  // namespace

Value Calls::call(const Tree& tree, const node::Call& node, NodeId id) {
    const Value* found = context_.scope.find(node.name);  // null for the functions of the language
    if (found && found->macro()) {
        OneValue one{context_.handlers};
        call_macro(tree, node, id, Sink(one));
        return context_.expressions->one_value(std::move(one), tree.span(id));
    }
    if (context_.expressions->builds_text(tree, id)) {
        std::string text;
        return context_.expressions->append_text(tree, id, text, node.name)
                   ? Value(std::move(text))
                   : Value(Absence::broken);
    }
    if (!found && is_function(node.name)) return call_function(tree, node, id);
    if (context_.names.reserved(node.name)) return call_function(tree, node, id);
    if (is_function(node.name)) {
        const Value called = *found;
        return call_value(tree, called, node.name, node.arguments, tree.span(id));
    }
    if (context_.word_call.tree == &tree && context_.word_call.first == id)
        return context_.expressions->group(tree, node.arguments, tree.span(id));
    called_macro(tree, node, id);  // reports the problem
    return Absence::broken;
}

bool Calls::is_function(NameId name) const {
    const Value* found = context_.scope.find(name);
    if (found) return found->formula() || found->handle<Spline>();
    const auto number = static_cast<std::size_t>(name);
    return number < context_.functions.size() && context_.functions[number];
}

Value Calls::call_value(const Tree& tree, const Value& called, NameId name, NodeId first,
                        Span span) {
    if (called.formula()) return call_formula(tree, called.handle<Formula>(), name, first, span);
    if (const auto spline = called.handle<Spline>())
        return call_spline(tree, spline, name, first, span);
    if (called.broken()) return called;
    return context_.broken(Fault::wrong_type, span,
                           message("this is ", kind_name(called), " and cannot be called"));
}

bool Calls::defined(const Tree& tree, NodeId target) {
    if (const auto* name = tree.get_if<node::Name>(target)) {
        const Value* found = context_.scope.find(name->name);
        return found != nullptr;
    }
    const auto* index = tree.get_if<node::Index>(target);
    if (!index) return false;
    Indices places;
    places.asking = true;
    if (!context_.expressions->indices(tree, index->indices, places)) return false;
    Value* array = context_.scope.edit(index->name);
    if (!array) return false;
    const bool room = context_.expressions->make_room(*array, places, 0, tree.span(target));
    context_.scope.edited();
    if (!room) return false;
    const Value found = context_.expressions->element(*array, places, tree.span(target));
    return !found.broken() && !found.is(Absence::uninitialised);
}

Value Calls::call_function(const Tree& tree, const node::Call& node, NodeId id) {
    const FunctionInfo* function = context_.functions[static_cast<std::size_t>(node.name)];
    const std::string_view name = context_.names.spelling(node.name);
    if (!function && name == "defined") {
        if (list_length(tree, node.arguments) != 1)
            return context_.broken(Fault::wrong_count, tree.span(id), "`defined` takes one name");
        return defined(tree, node.arguments) ? 1.0 : 0.0;
    }
    if (!function)
        return context_.broken(Fault::not_implemented, tree.span(id),
                               message("`", name, "` is known but not implemented"));

    const auto* unary = std::get_if<FunctionInfo::Unary>(&function->code);
    if (unary && node.arguments != no_node && tree[node.arguments].next == no_node &&
        !tree.get_if<node::If>(node.arguments)) {
        const std::optional<double> argument =
            context_.expressions->number(tree, node.arguments, "the argument of", node.name);
        return argument ? Value((*unary)(*argument)) : Value(Absence::broken);
    }
    std::vector<Value> values;
    std::vector<Span> places;
    values.reserve(4);
    places.reserve(4);
    bool good = true;
    walk_arguments(tree, node.arguments, [&](Value value, Span place) {
        good = good && !value.broken();
        values.push_back(std::move(value));
        places.push_back(place);
    });
    if (!good || context_.stopped()) return Absence::broken;
    const auto count = static_cast<int>(values.size());
    if (count < function->least || count > function->most) {
        context_.report(
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
        return Absence::broken;
    }
    // The arguments are read, and the result is as long as they are or a little longer.
    constexpr std::uint64_t each_call = 60, of_object = 1000;
    std::uint64_t amount = each_call;
    for (const Value& value : values)
        if (value.text())
            amount += 4 * value.text()->size();
        else if (value.handle<Object>())
            amount += of_object;
    if (!context_.costs.spend(amount, tree.span(id))) return Absence::broken;
    FunctionCall call(name, values, places, tree.span(id), context_.world);
    Value result = unary ? Value((*unary)(call.number(0)))
                         : (*std::get_if<FunctionInfo::General>(&function->code))(call);
    if (call.failed()) return Absence::broken;
    if (result.text() && !context_.costs.may_be_long(result.text()->size(), tree.span(id)))
        return Absence::broken;
    if (call.given()) receive(tree, node.arguments, count, *call.given());
    return result;
}

/// Stores a function's second result in the variable that its last argument names.
void Calls::receive(const Tree& tree, NodeId first, int count, const Value& value) {
    NodeId last = first;
    while (tree[last].next != no_node) last = tree[last].next;
    if (static_cast<int>(list_length(tree, first)) == count &&
        (tree.get_if<node::Name>(last) || tree.get_if<node::Index>(last))) {
        context_.statements->assign(tree, last, Value(value), false);
        return;
    }
    context_.report(
        error(Fault::wrong_type, tree.span(last), "here must be the name of a declared vector")
            .with_help("trace(object, from, direction, Normal) stores the normal in `Normal`"));
}

/// Arguments of a function: values, and directives and macros between them.
void Calls::walk_arguments(const Tree& tree, NodeId first, FunctionRef<void(Value, Span)> take) {
    for (NodeId id = first; id != no_node && !context_.stopped(); id = tree[id].next) {
        if (Statements::is_directive(tree, id) || macro_call(tree, id)) {
            context_.statements->walk_one(tree, id, [&](const Element& element) {
                take(context_.evaluator.value_of(element), element.span);
            });
        } else {
            take(context_.expressions->evaluate(tree, id), tree.span(id));
        }
    }
}

}  // namespace candelabra
