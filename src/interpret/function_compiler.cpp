// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/function_compiler.h"

#include "interpret/chain.h"
#include "interpret/compiler.h"
#include "interpret/sink.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace candelabra {

std::optional<ProgramBuilder::Operand> FunctionCompiler::wrong(Span span, std::string message) {
    context.broken(Fault::wrong_type, span, std::move(message));
    return std::nullopt;
}

/// Runs the directives and macros of a list and compiles the expressions that remain. One that
/// cannot be compiled is reported and counts as an expression.
void FunctionCompiler::list(const Tree& tree, NodeId first, std::vector<Operand>& values) {
    const auto take = [&](const Tree& from, NodeId id) { this->take(from, id, values); };
    context.statements->walk(tree, first, Sink(Sink::Written(take)));
}

void FunctionCompiler::take(const Tree& tree, NodeId id, std::vector<Operand>& values) {
    const auto* call = context.calls->macro_call(tree, id);
    if (!call) return values.push_back(expression(tree, id).value_or(ProgramBuilder::none));
    const std::size_t errors = context.diagnostics.error_count();
    const auto take = [&](const Tree& from, NodeId part) { this->take(from, part, values); };
    context.calls->call_macro(tree, *call, id, Sink(Sink::Written(take)));
    if (context.diagnostics.error_count() > errors) values.push_back(ProgramBuilder::none);
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::body(const Tree& tree, NodeId first,
                                                              Span span) {
    std::vector<Operand> values;
    list(tree, first, values);
    if (context.stopped()) return std::nullopt;
    if (std::find(values.begin(), values.end(), ProgramBuilder::none) != values.end())
        return std::nullopt;
    if (values.size() == 1) return values[0];
    context.broken(values.empty() ? Fault::missing : Fault::wrong_count, span,
                   message("a function is one expression, but here ",
                           values.empty() ? "is none" : message("are ", values.size())));
    return std::nullopt;
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::expression(const Tree& tree, NodeId id) {
    if (!context.room(tree, id)) return std::nullopt;
    const NodeContent& content = tree[id].content;
    switch (content.index()) {
        case kind<node::Number>:
            return builder.constant(tree.numbers[std::get_if<node::Number>(&content)->number]);
        case kind<node::Name>:
            return name(std::get_if<node::Name>(&content)->name, tree.span(id));
        case kind<node::Constant>:
            return name(std::get_if<node::Constant>(&content)->word, tree.span(id));
        case kind<node::Index>: {
            const Value value =
                context.expressions->index_value(tree, *std::get_if<node::Index>(&content), id);
            return constant(value, "this element", tree.span(id));
        }
        case kind<node::Group>:
            return body(tree, std::get_if<node::Group>(&content)->content, tree.span(id));
        case kind<node::Unary>:
            return unary(tree, *std::get_if<node::Unary>(&content), id);
        case kind<node::Binary>:
            return binary(tree, *std::get_if<node::Binary>(&content), id);
        case kind<node::Chain>:
            return open(tree, id);
        case kind<node::Member>:
            return member(tree, *std::get_if<node::Member>(&content), id);
        case kind<node::Call>:
            return call(tree, *std::get_if<node::Call>(&content), id);
        case kind<node::Apply>:
            return apply(tree, *std::get_if<node::Apply>(&content), id);
        case kind<node::Choice>:
            return wrong(tree.span(id),
                         "there is no `? :` in functions; select(v, a, b) gives a where v < 0");
        case kind<node::Broken>:
            return std::nullopt;
        default:
            if (tree.gives_elements(id)) return open(tree, id);
            return wrong(tree.span(id), "a function computes with single numbers only");
    }
}

/// A value that exists now is a constant of the function.
std::optional<ProgramBuilder::Operand> FunctionCompiler::constant(const Value& value,
                                                                  std::string_view what,
                                                                  Span span) {
    if (value.broken()) return std::nullopt;
    if (const Numbers* numbers = value.numbers(); numbers && numbers->is_scalar())
        return builder.constant(numbers->at[0]);
    return wrong(span, message("a function computes with single numbers only, and ", what, " is ",
                               kind_name(value)));
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::name(NameId name, Span span) {
    for (auto local = locals.rbegin(); local != locals.rend(); ++local)
        if (local->first == name) return local->second;
    const std::string_view spelling = context.names.spelling(name);
    if (!context.names.reserved(name))
        return constant(context.expressions->name_value(name, span), message("`", spelling, "`"),
                        span);
    if (spelling == "pi" || spelling == "clock")
        return builder.constant(context.expressions->constant(name).numbers()->at[0]);
    Diagnostic problem = error(Fault::unknown_name, span,
                               message("`", spelling, "` is no parameter of this function"));
    if (spelling == "true" || spelling == "yes" || spelling == "on")
        problem.with_help("write 1");
    else if (spelling == "false" || spelling == "no" || spelling == "off")
        problem.with_help("write 0");
    else
        problem.with_help("function (x, y, z) { ... } names the parameters");
    context.report(problem);
    return std::nullopt;
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::unary(const Tree& tree,
                                                               const node::Unary& node, NodeId id) {
    if (node.sign == Operator::no)
        return wrong(tree.span(id), "there is no `!` in functions; x = 0 does the same");
    if (context.calls->macro_call(tree, node.operand)) return open(tree, id);
    const Result operand = expression(tree, node.operand);
    return node.sign == Operator::plus ? operand : negative(operand);
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::negative(Result operand) {
    if (!operand) return operand;
    std::string written = worded("(-", text(*operand), ")");
    const Operand result = builder.emit(Operation::negate, *operand);
    builder.release(*operand);
    return said(result, std::move(written));
}

namespace {

bool is_logical(Operator sign) { return sign == Operator::both || sign == Operator::either; }

}  // namespace

std::optional<ProgramBuilder::Operand> FunctionCompiler::binary(const Tree& tree,
                                                                const node::Binary& node,
                                                                NodeId id) {
    if (is_logical(node.sign)) return logical(tree, id);
    if (node.open) return open(tree, id);
    const Result a = expression(tree, node.left);
    return combine(tree, node.sign, a, expression(tree, node.right), node.right);
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::combine(const Tree& tree, Operator sign,
                                                                 Result a, Result b, NodeId right) {
    if (!a || !b) return std::nullopt;
    if (sign == Operator::divide) return division(tree, *a, *b, right);
    return joined(operations_of(sign).exact, candelabra::spelling(sign), *a, *b);
}

/// Emits an operation of two values, which are not read afterwards.
ProgramBuilder::Operand FunctionCompiler::joined(Operation operation, std::string_view sign,
                                                 Operand a, Operand b) {
    std::string written = worded("(", text(a), " ", sign, " ", text(b), ")");
    const Operand result = builder.emit(operation, a, b);
    builder.release(a);
    builder.release(b);
    return said(result, std::move(written));
}

/// Passes of a loop are parts of the expression, each with the values that its names have then.
std::optional<ProgramBuilder::Operand> FunctionCompiler::open(const Tree& tree, NodeId id) {
    struct Placed {
        Result operand;
        const Tree* tree;
        NodeId id;
    };
    const auto joined = [&](Operator sign, Placed a, Placed b) -> Placed {
        return {combine(*b.tree, sign, a.operand, b.operand, b.id), a.tree, a.id};
    };
    ChainTotal<Placed> total;
    const bool good =
        context.expressions->walk_operands(tree, id, [&](const Expressions::Operand& part) {
            const Result operand = expression(part.tree, part.id);
            total.add(part.sign, {part.negative ? negative(operand) : operand, &part.tree, part.id},
                      joined);
        });
    const std::optional<Placed> result = total.result(joined);
    return good && result ? result->operand : std::nullopt;
}

/// Division by a constant is multiplication by its reciprocal, as in POV-Ray.
std::optional<ProgramBuilder::Operand> FunctionCompiler::division(const Tree& tree, Operand a,
                                                                  Operand b, NodeId divisor) {
    NodeId at = divisor;
    while (const auto* group = tree.get_if<node::Group>(at)) at = group->content;
    const double* known = builder.known(b);
    const bool plain = tree.get_if<node::Number>(at) || tree.get_if<node::Name>(at) ||
                       tree.get_if<node::Index>(at);
    if (!known) return joined(Operation::divide, "/", a, b);
    // A sign before the number keeps it from being plain.
    std::string written =
        worded("(", text(a), plain ? " / " : " / (+", text(b), plain ? ")" : "))");
    if (plain && *known == 0) {
        context.broken(Fault::division_by_zero, tree.span(divisor),
                       "this function always divides by zero");
        return std::nullopt;
    }
    const Operand result = plain
                               ? builder.emit(Operation::multiply, a, builder.constant(1 / *known))
                               : builder.emit(Operation::divide, a, b);
    builder.release(a);
    builder.release(b);
    return said(result, std::move(written));
}

/// In functions `&` binds closer than `|`. The parser treats both alike and groups from the left,
/// as in other expressions.
std::optional<ProgramBuilder::Operand> FunctionCompiler::logical(const Tree& tree, NodeId id) {
    std::vector<std::pair<Operator, NodeId>> parts;  // each with the sign before it
    const auto* node = tree.get_if<node::Binary>(id);
    NodeId first = id;
    for (; node && is_logical(node->sign); node = tree.get_if<node::Binary>(first)) {
        parts.push_back({node->sign, node->right});
        first = node->left;
    }
    parts.push_back({Operator::either, first});
    std::reverse(parts.begin(), parts.end());

    std::vector<Operand> alternatives;
    for (const auto& [sign, part] : parts) {
        const Result value = expression(tree, part);
        if (!value) return std::nullopt;
        if (sign == Operator::both)
            alternatives.back() = joined(Operation::both, "&", alternatives.back(), *value);
        else
            alternatives.push_back(*value);
    }
    Operand result = alternatives[0];
    for (std::size_t i = 1; i < alternatives.size(); ++i)
        result = joined(Operation::either, "|", result, alternatives[i]);
    return result;
}

using FunctionOperands = std::vector<ProgramBuilder::Operand>;

std::optional<FunctionOperands> FunctionCompiler::arguments(const Tree& tree, NodeId first) {
    std::vector<Operand> values;
    list(tree, first, values);
    const bool bad = std::ranges::find(values, ProgramBuilder::none) != values.end();
    return bad || context.stopped() ? std::nullopt : std::optional(values);
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::call(const Tree& tree,
                                                              const node::Call& node, NodeId id) {
    const std::string_view spelling = context.names.spelling(node.name);
    if (spelling == "sum" || spelling == "prod") return loop(tree, node, id);
    if (context.names.reserved(node.name)) return function(tree, node, id);
    const Value* found = context.scope.find(node.name);
    if (found && found->macro()) return open(tree, id);
    if (const auto function = called(tree, id)) return call_one(tree, *function, id);
    return constant(context.expressions->name_value(node.name, tree.span(id)),
                    message("`", spelling, "`"), tree.span(id));
}

std::optional<FunctionCompiler::Called> FunctionCompiler::called(const Tree& tree, NodeId id) {
    if (const auto* call = tree.get_if<node::Call>(id)) {
        const Value* found = context.scope.find(call->name);
        if (!found || !found->formula()) return std::nullopt;
        return Called{found->handle<Formula>(), call->name, call->arguments};
    }
    const auto* apply = tree.get_if<node::Apply>(id);
    if (!apply) return std::nullopt;
    const auto& index = tree.get<node::Index>(apply->function);
    const Value found = context.expressions->index_value(tree, index, apply->function);
    if (!found.formula() && !found.broken()) return std::nullopt;
    return Called{found.handle<Formula>(), index.name, apply->arguments};
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::apply(const Tree& tree,
                                                               const node::Apply& node, NodeId id) {
    if (const auto function = called(tree, id)) return call_one(tree, *function, id);
    return wrong(tree.span(node.function), "this element is no function");
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::call_one(const Tree& tree,
                                                                  const Called& called, NodeId id) {
    if (!called.formula) return std::nullopt;
    if (called.formula->results() == 1) return call_formula(tree, called, id);
    return wrong(tree.span(id),
                 message("`", context.names.spelling(called.name), "` gives a vector of ",
                         called.formula->results(), ", of which a function uses one part: ",
                         context.names.spelling(called.name), "(...).x"));
}

/// Returns the first result; the others are in the registers after it.
std::optional<ProgramBuilder::Operand> FunctionCompiler::call_formula(const Tree& tree,
                                                                      const Called& called,
                                                                      NodeId id) {
    const auto values = arguments(tree, called.arguments);
    if (!values) return std::nullopt;
    if (!context.calls->check_count(called.name, values->size(), *called.formula, tree.span(id)))
        return std::nullopt;
    std::string written = worded(called_text(called.formula), "(", texts(*values), ")");
    const Operand first = builder.call(called.formula, *values);
    for (const Operand value : *values) builder.release(value);
    return said(first, std::move(written));
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::member(const Tree& tree,
                                                                const node::Member& node,
                                                                NodeId id) {
    const auto function = called(tree, node.operand);
    if (!function)
        return wrong(tree.span(id),
                     "in a function, only what another function gives has parts: f(x, y, z).x");
    if (!function->formula) return std::nullopt;
    const Result first = call_formula(tree, *function, node.operand);
    if (!first) return std::nullopt;
    const std::string_view member = context.names.spelling(node.member);
    const std::size_t count = function->formula->results();
    std::string written = worded(text(*first), ".", member);
    const Result result = part(member, *first, count);
    for (std::size_t i = 0; i < count; ++i) {
        const Operand other = ProgramBuilder::following(*first, i);
        if (!result || other != *result) builder.release(other);
    }
    if (!result)
        context.broken(Fault::bad_index, tree.span(id),
                       message("there is no `.", member, "` in the ", count, " numbers of `",
                               context.names.spelling(function->name), "`"));
    return result ? said(*result, std::move(written)) : result;
}

/// A component, or a weighted sum of components, of numbers in consecutive registers.
std::optional<ProgramBuilder::Operand> FunctionCompiler::part(std::string_view member,
                                                              Operand first, std::size_t count) {
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
std::optional<ProgramBuilder::Operand> FunctionCompiler::loop(const Tree& tree,
                                                              const node::Call& node, NodeId id) {
    std::vector<NodeId> parts;
    for (NodeId part = node.arguments; part != no_node; part = tree[part].next)
        parts.push_back(part);
    const bool sums = context.names.spelling(node.name) == "sum";
    const auto* counter = parts.empty() ? nullptr : tree.get_if<node::Name>(parts[0]);
    if (parts.size() != 4 || !counter || context.scope.find(counter->name)) {
        context.report(
            error(counter && parts.size() == 4 ? Fault::redefinition : Fault::wrong_count,
                  parts.empty() ? tree.span(id) : tree.span(parts[0]),
                  message("`", context.names.spelling(node.name),
                          "` counts with a name that stands for nothing else"))
                .with_help(message(context.names.spelling(node.name),
                                   "(i, 1, 10, i * i): counter, first, last, expression")));
        return std::nullopt;
    }
    const Result first = expression(tree, parts[1]), last = expression(tree, parts[2]);
    if (!first || !last) return std::nullopt;
    const std::string counted = worded("i", ++counters);
    std::string written = worded(context.names.spelling(node.name), "(", counted, ", ",
                                 text(*first), ", ", text(*last), ", ");
    const Operand i = builder.variable(), result = builder.variable();
    builder.pin(i);  // else each reading of the counter would release it
    builder.assign(i, *first);
    builder.assign(result, builder.constant(sums ? 0 : 1));
    builder.release(*first);
    const std::size_t start = builder.here();
    const Operand goes_on = builder.emit(Operation::less_equal, i, *last);
    const std::size_t end = builder.jump_unless(goes_on);
    builder.release(goes_on);
    locals.push_back({counter->name, said(i, counted, true)});
    const Result term = expression(tree, parts[3]);
    locals.pop_back();
    if (!term) return std::nullopt;
    written += text(*term) + ")";
    builder.update(sums ? Operation::add : Operation::multiply, result, *term);
    builder.release(*term);
    builder.update(Operation::add, i, builder.constant(1));
    builder.repeat(start);
    builder.land(end);
    builder.unpin(i);
    spoken.erase(i);
    builder.release(*last);
    return said(result, std::move(written));
}

ProgramBuilder::Operand FunctionCompiler::function_of_two(std::string_view name, Operand a,
                                                          Operand b) {
    const double* exponent = name == "pow" ? builder.known(b) : nullptr;
    if (exponent && *exponent >= 0 && *exponent <= 8 && *exponent == static_cast<int>(*exponent))
        return builder.whole_power(a, static_cast<int>(*exponent));
    return builder.emit(*operation_of_two(name), a, b);
}

std::optional<ProgramBuilder::Operand> FunctionCompiler::function(const Tree& tree,
                                                                  const node::Call& node,
                                                                  NodeId id) {
    const std::string_view name = context.names.spelling(node.name);
    const auto of_one = function_number(name);
    const bool of_two = operation_of_two(name).has_value();
    const bool extreme = name == "min" || name == "max", select = name == "select";
    if (!of_one && !of_two && !extreme && !select) {
        Diagnostic problem = error(Fault::wrong_type, tree.span(id),
                                   message("`", name, "` cannot be used in functions"));
        if (name == "rand")
            problem.with_help(
                "a function has the same value at every call; at random over "
                "space is f_noise3d(x, y, z) of functions.inc");
        context.report(problem);
        return std::nullopt;
    }
    const auto values = arguments(tree, node.arguments);
    if (!values) return std::nullopt;
    const std::size_t least = of_one ? 1 : select ? 3 : 2;
    const std::size_t most = extreme ? values->size() : select ? 4 : least;
    if (values->size() < least || values->size() > most) {
        context.broken(
            Fault::wrong_count, tree.span(id),
            message("in a function, `", name, "` takes ", extreme ? "at least " : "", least,
                    select ? " or 4" : "", least == 1 ? " argument" : " arguments", ", but here ",
                    values->size() == 1 ? "is " : "are ", values->size()));
        return std::nullopt;
    }
    std::string written = worded(name, "(", texts(*values), ")");
    if (extreme)
        return said(builder.fold(name == "min" ? Operation::least : Operation::greatest, *values),
                    std::move(written));
    if (select) return said(builder.select(*values), std::move(written));
    const Operand result = of_one ? builder.apply(*of_one, (*values)[0])
                                  : function_of_two(name, (*values)[0], (*values)[1]);
    for (const Operand value : *values)
        if (value != result) builder.release(value);
    return said(result, std::move(written));
}

// ---- the text, with numbers for all names that are constants, and with parentheses around each
// operation, so that it compiles to the same program

namespace {

/// A number of which the compiler makes the same constant.
std::string constant_text(double x) {
    if (std::isnan(x)) return "(1e308*10 - 1e308*10)";
    if (std::isinf(x)) return x > 0 ? "(1e308*10)" : "(-1e308*10)";
    return std::signbit(x) ? message("(-", -x, ")") : message(x);
}

}  // namespace

ProgramBuilder::Operand FunctionCompiler::said(Operand operand, std::string text, bool stays) {
    if (!FunctionTexts::kept()) return operand;
    // pow(x, 1) is x.
    const auto [known, added] = spoken.try_emplace(operand);
    if (added || stays || !known->second.stays) known->second = {std::move(text), stays};
    return operand;
}

std::string FunctionCompiler::text(Operand operand) {
    if (!FunctionTexts::kept()) return {};
    if (const double* known = builder.known(operand)) return constant_text(*known);
    const auto found = spoken.find(operand);
    if (found == spoken.end()) return {};
    return found->second.stays ? found->second.text : std::move(found->second.text);
}

std::string FunctionCompiler::texts(std::span<const Operand> operands) {
    if (!FunctionTexts::kept()) return {};
    std::string all;
    for (const Operand each : operands) {
        if (!all.empty()) all += ", ";
        all += text(each);
    }
    return all;
}

std::string FunctionCompiler::called_text(const Handle<Formula>& formula) {
    if (!FunctionTexts::kept()) return {};
    const auto found = std::ranges::find(whole.called, formula);
    const auto number = static_cast<std::size_t>(found - whole.called.begin());
    if (found == whole.called.end()) whole.called.push_back(formula);
    return message(std::string(1, FormulaText::begin), number, std::string(1, FormulaText::end));
}

void FunctionCompiler::name_parameters(std::size_t count, bool listed) {
    if (!FunctionTexts::kept()) return;
    constexpr std::string_view usual = "xyz";
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name = listed ? message("p", i + 1) : std::string(1, usual[i]);
        said(locals[i].second, name, true);
        if (listed) whole.parameters += (i > 0 ? ", " : "(") + name;
    }
    if (listed) whole.parameters += ")";
}

FormulaText FunctionCompiler::whole_text(Operand result) {
    whole.body = text(result);
    return std::move(whole);
}

}  // namespace candelabra
