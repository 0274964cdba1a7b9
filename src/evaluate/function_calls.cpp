// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/function_compiler.h"
#include "text/message.h"

#include <algorithm>
#include <array>

using FunctionOperands = std::vector<ProgramBuilder::Operand>;

std::optional<FunctionOperands> Evaluator::State::FunctionCompiler::arguments(const Tree& tree,
                                                                              NodeId first) {
    std::vector<Operand> values;
    list(tree, first, values);
    const bool bad = std::ranges::find(values, ProgramBuilder::none) != values.end();
    return bad || state.stopped_ ? std::nullopt : std::optional(values);
}

std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::call(
    const Tree& tree, const node::Call& node, NodeId id) {
    const std::string_view spelling = state.names.spelling(node.name);
    if (spelling == "sum" || spelling == "prod") return loop(tree, node, id);
    if (state.names.reserved(node.name)) return function(tree, node, id);
    const Value* found = state.scope.find(node.name);
    if (found && found->macro()) return open(tree, id);
    if (!found || !found->formula())
        return constant(state.name_value(node.name, tree.span(id)), message("`", spelling, "`"),
                        tree.span(id));
    const std::size_t results = found->formula()->results();
    if (results > 1)
        return wrong(tree.span(id),
                     message("`", spelling, "` gives a vector of ", results,
                             ", of which a function uses one part: ", spelling, "(...).x"));
    return call_formula(tree, node, id, found->handle<Formula>());
}

/// The first result; the others are in the registers behind it.
std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::call_formula(
    const Tree& tree, const node::Call& node, NodeId id, Handle<Formula> formula) {
    const auto values = arguments(tree, node.arguments);
    if (!values) return std::nullopt;
    if (!state.check_count(node.name, values->size(), *formula, tree.span(id))) return std::nullopt;
    const Operand first = builder.call(std::move(formula), *values);
    for (const Operand value : *values) builder.release(value);
    return first;
}

std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::member(
    const Tree& tree, const node::Member& node, NodeId id) {
    const auto* call = tree.get_if<node::Call>(node.operand);
    const Value* found = call ? state.scope.find(call->name) : nullptr;
    if (!found || !found->formula())
        return wrong(tree.span(id),
                     "in a function, only what another function gives has parts: f(x, y, z).x");
    const Handle<Formula> formula = found->handle<Formula>();
    const Result first = call_formula(tree, *call, node.operand, formula);
    if (!first) return std::nullopt;
    const std::string_view member = state.names.spelling(node.member);
    const std::size_t count = formula->results();
    const Result result = part(member, *first, count);
    for (std::size_t i = 0; i < count; ++i) {
        const Operand other = ProgramBuilder::following(*first, i);
        if (!result || other != *result) builder.release(other);
    }
    if (!result)
        state.broken(Fault::bad_index, tree.span(id),
                     message("there is no `.", member, "` in the ", count, " numbers of `",
                             state.names.spelling(call->name), "`"));
    return result;
}

/// A component, or a mixture of some, of numbers in registers that follow each other.
std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::part(
    std::string_view member, Operand first, std::size_t count) {
    const auto mixed = [&](std::span<const double> weights) -> Result {
        if (count < weights.size()) return std::nullopt;
        std::vector<Operand> products;
        for (std::size_t i = 0; i < weights.size(); ++i)
            products.push_back(builder.emit(Operation::multiply,
                                            ProgramBuilder::following(first, i),
                                            builder.constant(weights[i])));
        return builder.fold(Operation::add, products);
    };
    if (member == "hf") return mixed(std::array{0.996093, 0.996093 / 255});
    const int component = component_of(member);
    if (component == grey_component) return mixed(grey_weights);
    if (component < 0 || component >= static_cast<int>(count)) return std::nullopt;
    return ProgramBuilder::following(first, static_cast<std::size_t>(component));
}

/// sum(i, first, last, e) and prod(...).
std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::loop(
    const Tree& tree, const node::Call& node, NodeId id) {
    std::vector<NodeId> parts;
    for (NodeId part = node.arguments; part != no_node; part = tree[part].next)
        parts.push_back(part);
    const bool sums = state.names.spelling(node.name) == "sum";
    const auto* counter = parts.empty() ? nullptr : tree.get_if<node::Name>(parts[0]);
    if (parts.size() != 4 || !counter || state.scope.find(counter->name)) {
        state.report(
            error(counter && parts.size() == 4 ? Fault::redefinition : Fault::wrong_count,
                  parts.empty() ? tree.span(id) : tree.span(parts[0]),
                  message("`", state.names.spelling(node.name),
                          "` counts with a name that stands for nothing else"))
                .with_help(message(state.names.spelling(node.name),
                                   "(i, 1, 10, i * i): counter, first, last, expression")));
        return std::nullopt;
    }
    const Result first = expression(tree, parts[1]), last = expression(tree, parts[2]);
    if (!first || !last) return std::nullopt;
    const Operand i = builder.variable(), result = builder.variable();
    builder.pin(i);  // whoever reads the counter releases it
    builder.assign(i, *first);
    builder.assign(result, builder.constant(sums ? 0 : 1));
    builder.release(*first);
    const std::size_t start = builder.here();
    const Operand goes_on = builder.emit(Operation::less_equal, i, *last);
    const std::size_t end = builder.jump_unless(goes_on);
    builder.release(goes_on);
    locals.push_back({counter->name, i});
    const Result term = expression(tree, parts[3]);
    locals.pop_back();
    if (!term) return std::nullopt;
    builder.update(sums ? Operation::add : Operation::multiply, result, *term);
    builder.release(*term);
    builder.update(Operation::add, i, builder.constant(1));
    builder.repeat(start);
    builder.land(end);
    builder.unpin(i);
    builder.release(*last);
    return result;
}

ProgramBuilder::Operand Evaluator::State::FunctionCompiler::function_of_two(std::string_view name,
                                                                            Operand a, Operand b) {
    const double* exponent = name == "pow" ? builder.known(b) : nullptr;
    if (exponent && *exponent >= 0 && *exponent <= 8 && *exponent == static_cast<int>(*exponent))
        return builder.whole_power(a, static_cast<int>(*exponent));
    return builder.emit(*operation_of_two(name), a, b);
}

std::optional<ProgramBuilder::Operand> Evaluator::State::FunctionCompiler::function(
    const Tree& tree, const node::Call& node, NodeId id) {
    const std::string_view name = state.names.spelling(node.name);
    const auto of_one = function_number(name);
    const bool of_two = operation_of_two(name).has_value();
    const bool extreme = name == "min" || name == "max", select = name == "select";
    if (!of_one && !of_two && !extreme && !select) {
        Diagnostic problem = error(Fault::wrong_type, tree.span(id),
                                   message("`", name, "` cannot be used in functions"));
        if (name == "rand")
            problem.with_help(
                "a function gives the same whenever it is asked; at random over "
                "space is f_noise3d(x, y, z) of functions.inc");
        state.report(problem);
        return std::nullopt;
    }
    const auto values = arguments(tree, node.arguments);
    if (!values) return std::nullopt;
    const std::size_t least = of_one ? 1 : select ? 3 : 2;
    const std::size_t most = extreme ? values->size() : select ? 4 : least;
    if (values->size() < least || values->size() > most) {
        state.broken(Fault::wrong_count, tree.span(id),
                     message("in a function, `", name, "` takes ", extreme ? "at least " : "",
                             least, select ? " or 4" : "", least == 1 ? " argument" : " arguments",
                             ", but here ", values->size() == 1 ? "is " : "are ", values->size()));
        return std::nullopt;
    }
    if (extreme)
        return builder.fold(name == "min" ? Operation::least : Operation::greatest, *values);
    if (select) return builder.select(*values);
    const Operand result = of_one ? builder.apply(*of_one, (*values)[0])
                                  : function_of_two(name, (*values)[0], (*values)[1]);
    for (const Operand value : *values)
        if (value != result) builder.release(value);
    return result;
}
