// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/macro.h"

#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// Whether an argument is a difference like `1 -2`, where a comma was meant.
bool has_minus_for_comma(const Tree& tree, NodeId call, std::string_view text) {
    const auto* arguments_ = tree.get_if<node::Call>(call);
    for (NodeId id = arguments_ ? arguments_->arguments : no_node; id != no_node;
         id = tree[id].next) {
        const auto* sum = tree.get_if<node::Binary>(id);
        if (!sum || sum->sign != Operator::subtract) continue;
        const std::string_view right = text.substr(0, tree[sum->right].first);
        if (right.ends_with(" -") || right.ends_with("\t-")) return true;
    }
    return false;
}

}  // namespace

void Calls::define_macro(const Tree& tree, const node::Macro& node, NodeId id) {
    const Value* before = context_.scope.find(node.name);
    if (before && !before->macro()) {
        context_.broken(Fault::redefinition, tree.span(id),
                        message("`", context_.names.spelling(node.name), "` is declared as ",
                                kind_name(*before), " and cannot become a macro"));
        return;
    }
    const auto [found, fresh] = macros_.try_emplace({tree.source, id});
    MacroData& macro = found->second;
    if (fresh) {
        macro.name = node.name;
        macro.body = {&tree, node.body};
        for (NodeId parameter = node.parameters; parameter != no_node;
             parameter = tree[parameter].next) {
            const auto& info = tree.get<node::Parameter>(parameter);
            macro.parameters.push_back(
                {info.name, info.optional,
                 MacroContract::read(tree, info.contract, context_.names, context_.diagnostics)});
            if (!info.optional) macro.least = macro.parameters.size();
            if (!macro.parameters.back().contract.empty()) macro.has_contracts = true;
        }
        macro.defined = context_.heading(tree, id, node.name);
    }
    context_.scope.declare(node.name, &macro);
}

bool Calls::argument_element(const Tree& tree, const node::Index& index, NodeId id,
                             Argument& result) {
    Indices places;
    context_.note_use(index.name, tree, id);
    if (!context_.expressions->indices(tree, index.indices, places)) return false;
    const Value* array = context_.scope.find(index.name);
    if (array) {
        std::size_t used = 0;
        if (!context_.expressions->check_array(*array, tree.span(id))) return false;
        const std::optional<std::size_t> i =
            context_.expressions->place(*array->array(), places, used, tree.span(id));
        if (!i) return false;
        const Scope::Reference base = context_.scope.reference(index.name);
        if (used == places.count && base.element < 0 && array->array()->has(*i)) {
            result.place = {base.cell, static_cast<std::int64_t>(*i)};
            return true;
        }
    }
    return by_value(context_.expressions->index_value(tree, index, id), result);
}

/// A lone name or element is passed by reference, anything else by value.
bool Calls::argument(const Tree& tree, NodeId id, Argument& result) {
    if (const auto* name = tree.get_if<node::Name>(id)) {
        context_.note_use(name->name, tree, id);
        const Value* found = context_.scope.find(name->name);
        if (found && !found->absent() && !found->macro()) {
            result.place = context_.scope.reference(name->name);
            return true;
        }
    } else if (const auto* index = tree.get_if<node::Index>(id)) {
        return argument_element(tree, *index, id, result);
    }
    Numbers numbers;
    if (context_.expressions->compute(tree, id, numbers)) return by_value(numbers, result);
    return by_value(context_.expressions->walk_expression(tree, id), result);
}

bool Calls::keeps_contracts(const MacroData& macro, std::size_t base) {
    bool kept = true;
    for (std::size_t i = base; i < arguments_.size(); ++i) {
        const MacroData::Parameter& parameter = macro.parameters[i - base];
        if (arguments_[i].omitted || parameter.contract.empty()) continue;
        const auto limits = limits_of(parameter, *macro.body.tree, kept);
        const std::string refusal =
            limits ? parameter.contract.refusal(*context_.scope.find(parameter.name),
                                                               *limits)
                                  : "";
        if (limits && refusal.empty()) continue;
        kept = false;
        if (limits)
            context_.report(
                error(Fault::out_of_range, arguments_[i].given,
                      message('`', context_.names.spelling(parameter.name), "` of `",
                              context_.names.spelling(macro.name), "` must be ", refusal))
                    .pointing(macro.defined, "defined here"));
    }
    return kept;
}

std::optional<std::vector<MacroContract::Limit>> Calls::limits_of(
    const MacroData::Parameter& parameter, const Tree& tree, bool kept) {
    std::vector<MacroContract::Limit> limits;
    for (const node::Bound& bound : parameter.contract.bounds()) {
        const auto* name = tree.get_if<node::Name>(bound.value);
        const Value* named = name ? context_.scope.find(name->name) : nullptr;
        if (!kept && named && !named->numbers()) return std::nullopt;
        const std::optional<double> limit =
            context_.expressions->number(tree, bound.value, "a bound");
        if (!limit) return std::nullopt;
        limits.push_back(
            {bound.sign, *limit, std::string(name ? context_.names.spelling(name->name) : "")});
    }
    return limits;
}

void Calls::report_arguments(const MacroData& macro, std::size_t count, const Tree& tree,
                             NodeId call) {
    const std::size_t least = macro.least, most = macro.parameters.size();
    std::string list;
    for (const MacroData::Parameter& parameter : macro.parameters)
        list += message(list.empty() ? "" : ", ", parameter.optional ? "optional " : "",
                        context_.names.spelling(parameter.name));
    Diagnostic problem = error(Fault::wrong_count, tree.span(call),
                               message("macro `", context_.names.spelling(macro.name), "` takes ",
                                       least == most ? message(most) : message(least, " to ", most),
                                       most == 1 ? " argument" : " arguments", ", but here ",
                                       count == 1 ? "is " : "are ", count));
    problem.pointing(macro.defined,
                     message("defined as ", context_.names.spelling(macro.name), "(", list, ")"));
    if (count < least && has_minus_for_comma(tree, call, context_.sources.text(tree.source)))
        problem.with_help("a value and a `-` behind it are one value: a comma keeps them apart");
    context_.report(problem);
}

/// Passes the values that a macro yields, perhaps several, as arguments of another.
bool Calls::pass_values(const Tree& tree, const node::Call& inner, NodeId id) {
    bool good = true;
    const std::size_t depth = arguments_.size();
    call_macro(tree, inner, id, [&](const Element& element) {
        Argument one;
        one.given = tree.span(id);
        good = by_value(context_.evaluator.value_of(element), one) && good;
        arguments_.push_back(one);
    });
    if (arguments_.size() > depth || !good) return good;
    context_.expressions->report_count(0, tree.span(id));
    return false;
}

/// Whether the argument gives no value: a gap between commas, or what is not declared.
bool Calls::gives_nothing(const Tree& tree, NodeId id) {
    if (tree.get_if<node::Omitted>(id)) return true;
    if (const auto* name = tree.get_if<node::Name>(id))
        return !context_.expressions->value_named(name->name);
    return tree.get_if<node::Index>(id) && !defined(tree, id);
}

bool Calls::pass_argument(const Tree& tree, NodeId id, const MacroData& macro, std::size_t place,
                          Argument& result) {
    const auto* parameter = place < macro.parameters.size() ? &macro.parameters[place] : nullptr;
    if (parameter && parameter->optional && gives_nothing(tree, id)) {
        result.omitted = true;
        return true;
    }
    if (!tree.get_if<node::Omitted>(id)) return argument(tree, id, result);
    Diagnostic problem = error(
        Fault::missing, tree.span(id),
        parameter ? message("macro `", context_.names.spelling(macro.name), "` needs a value for `",
                            context_.names.spelling(parameter->name), "`, which is left out here")
                  : message("two commas in a row"));
    if (parameter) problem.pointing(macro.defined, "defined here");
    context_.report(
        problem.with_help(message("only what is marked in #macro can be left out: #macro ",
                                  context_.names.spelling(macro.name), "(..., optional A)")));
    return false;
}

bool Calls::pass_arguments(const Tree& tree, const node::Call& node, NodeId id,
                           const MacroData& macro) {
    const std::size_t base = arguments_.size();
    bool good = true;
    for (NodeId at = node.arguments; at != no_node && !context_.stopped(); at = tree[at].next) {
        if (const auto* inner = macro_call(tree, at)) {
            good = pass_values(tree, *inner, at) && good;
            continue;
        }
        Argument one;
        one.given = tree.span(at);
        good = pass_argument(tree, at, macro, arguments_.size() - base, one) && good;
        arguments_.push_back(one);
    }
    const std::size_t count = arguments_.size() - base;
    if (good && !context_.stopped() && (count < macro.least || count > macro.parameters.size())) {
        report_arguments(macro, count, tree, id);
        good = false;
    }
    if (good && !context_.stopped()) return true;
    for (; arguments_.size() > base; arguments_.pop_back())
        if (arguments_.back().by_value && arguments_.back().place.cell)
            context_.scope.give_back(arguments_.back().place.cell);
    return false;
}

const MacroData* Calls::called_macro(const Tree& tree, const node::Call& node, NodeId id) {
    context_.note_use(node.name, tree, id);
    const Value* found = context_.scope.find(node.name);
    if (!found) {
        const auto length = static_cast<std::uint32_t>(context_.names.spelling(node.name).size());
        context_.unknown_name(node.name, {tree.source, tree[id].first, tree[id].first + length});
        return nullptr;
    }
    if (found->is(Absence::uninitialised))
        context_.broken(Fault::uninitialised, tree.span(id),
                        message("`", context_.names.spelling(node.name), "` has no value"));
    else if (!found->macro() && !found->broken())
        context_.report(error(Fault::wrong_type, tree.span(id),
                              message("`", context_.names.spelling(node.name), "` is ",
                                      kind_name(*found), " and cannot be called"))
                            .with_help(found->array()
                                           ? message("an element of it is written ",
                                                     context_.names.spelling(node.name), "[0]")
                                           : ""));
    return found->macro();
}

const MacroData* Calls::enter_macro(const Tree& tree, const node::Call& node, NodeId id) {
    const MacroData* macro = called_macro(tree, node, id);
    if (!macro || context_.costs.too_many_steps(tree, id)) return nullptr;
    if (context_.frames.depth() >= context_.costs.limits.call_depth) {
        if (!context_.stopped())
            context_.report(
                error(Fault::recursion_limit, tree.span(id),
                      message("macros call each other ", context_.costs.limits.call_depth,
                              " deep, which is the limit"))
                    .with_help("a recursion needs an #if that ends it; --limit-depth raises the "
                               "limit"));
        context_.stop();
        return nullptr;
    }
    constexpr std::uint64_t each = 80;
    context_.costs.work += each;
    const std::size_t base = arguments_.size();
    if (!pass_arguments(tree, node, id, *macro)) return nullptr;
    context_.scope.enter();
    for (std::size_t i = base; i < arguments_.size(); ++i) {
        const Argument& argument = arguments_[i];
        if (argument.omitted) continue;
        const NameId name = macro->parameters[i - base].name;
        if (argument.by_value)
            context_.scope.bind_parameter(name, argument.place.cell);
        else
            context_.scope.alias(name, argument.place);
    }
    const bool kept = !macro->has_contracts || keeps_contracts(*macro, base);
    arguments_.resize(base);
    if (!kept) {
        context_.scope.leave();
        return nullptr;
    }
    context_.frames.push({Frame::macro, macro->name, no_source, tree.span(id)});
    return macro;
}

void Calls::leave_macro() {
    context_.frames.pop();
    context_.scope.leave();
}

Flow Calls::call_macro(const Tree& tree, const node::Call& node, NodeId id, const Sink& take) {
    if (!context_.room(tree, id)) return Flow::stopped;
    const MacroData* macro = enter_macro(tree, node, id);
    if (!macro) {
        if (context_.stopped()) return Flow::stopped;
        take.value(Absence::broken, tree, id);
        return context_.stopped() ? Flow::stopped : Flow::end;
    }
    const Flow flow = context_.statements->walk(*macro->body.tree, macro->body.first, take);
    leave_macro();
    return flow == Flow::stopped ? Flow::stopped
                                 : Flow::end;  // a #break outside loops ends the macro
}

const node::Call* Calls::macro_call(const Tree& tree, NodeId id) const {
    const auto* call = tree.get_if<node::Call>(id);
    const Value* found = call ? context_.scope.find(call->name) : nullptr;
    return found && found->macro() ? call : nullptr;
}

}  // namespace candelabra
