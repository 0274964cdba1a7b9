// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions: numbers of one to five components with POV-Ray's rules of promotion, strings, and
// colours.
#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/previous.h"
#include "interpret/statements.h"
#include "text/message.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numbers>

namespace candelabra {

namespace {

double apply(Operator sign, double a, double b) {
    switch (sign) {
        case Operator::add:
            return a + b;
        case Operator::subtract:
            return a - b;
        case Operator::multiply:
            return a * b;
        case Operator::divide:
            return b == 0 ? std::numeric_limits<double>::infinity() : a / b;
        case Operator::less:
            return a < b;
        case Operator::less_equal:
            return a <= b || about(a, b);
        case Operator::equal:
            return about(a, b);
        case Operator::not_equal:
            return !about(a, b);
        case Operator::greater_equal:
            return a >= b || about(a, b);
        case Operator::greater:
            return a > b;
        case Operator::both:
            return is_true(a) && is_true(b);
        case Operator::either:
            return is_true(a) || is_true(b);
        default:
            return 0;
    }
}

bool is_comparison(Operator sign) { return sign >= Operator::less && sign <= Operator::greater; }

/// The sum of values of which each but the first begins with a sign, as in
/// `(#include "five.inc" + 1)`; nothing for other elements.
std::optional<Numbers> sum(std::span<const Element> elements, const SourceStore& sources) {
    Numbers total = Numbers::scalar(0);
    for (const Element& element : elements) {
        const Numbers* numbers =
            element.kind == Element::Kind::value ? element.value.numbers() : nullptr;
        const char sign = sources.text(element.span.source)[element.span.first];
        if (!numbers || (&element != &elements.front() && sign != '+' && sign != '-'))
            return std::nullopt;
        const int count = std::max(total.count, numbers->count);
        const Numbers one = numbers->count < count ? numbers->promoted(count) : *numbers;
        if (total.count < count) total = total.promoted(count);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) total.at[i] += one.at[i];
    }
    return total;
}

}  // namespace

Value Expressions::evaluate(const Tree& tree, NodeId id) {
    Numbers numbers;
    if (compute(tree, id, numbers)) return numbers;
    return walk_expression(tree, id);
}

Value Expressions::name_value(NameId name, Span span) {
    const Value* found = value_named(name);
    if (!found) return context_.unknown_name(name, span);
    if (found->macro())
        return context_.broken(Fault::wrong_type, span,
                               message("`", context_.names.spelling(name),
                                       "` is a macro: its call needs parentheses"));
    if (found->is(Absence::uninitialised))
        return context_.broken(Fault::uninitialised, span,
                               message("`", context_.names.spelling(name), "` has no value"));
    return *found;
}

Value Expressions::index_value(const Tree& tree, const node::Index& index, NodeId id) {
    Indices places;
    context_.note_use(index.name, tree, id);
    if (!indices(tree, index.indices, places)) return Absence::broken;
    const Value* array = context_.scope.find(index.name);
    if (!array) return context_.unknown_name(index.name, tree.span(id));
    Value found = element(*array, places, tree.span(id));
    if (found.is(Absence::uninitialised))
        return context_.broken(Fault::uninitialised, tree.span(id),
                               "this element of the array was never set");
    return found;
}

[[gnu::noinline]] Value Expressions::take_tuple(const Tree& tree, NodeId id) {
    std::vector<Value>& values = *std::exchange(context_.awaited_tuple, nullptr);
    for (NodeId each = tree.get<node::Tuple>(id).content; each != no_node; each = tree[each].next)
        values.push_back(evaluate(tree, each));
    return Numbers::scalar(static_cast<double>(values.size()));
}

// Not inlined, so that nested expressions do not each reserve stack for a message.
[[gnu::noinline]] Value Expressions::refuse_tuple(const Tree& tree, NodeId id) {
    const std::string_view before = context_.sources.text(tree.source).substr(0, tree[id].first);
    const std::size_t last = before.find_last_not_of(" \t");
    const bool elements = last != before.npos && before[last] == ']';
    const NodeId ahead = previous(tree, id);
    const auto* word = ahead == no_node ? nullptr : tree.get_if<node::Word>(ahead);
    if (word && context_.reported.tree == &tree && context_.reported.first == ahead)
        return Absence::broken;
    Diagnostic problem = error(
        Fault::wrong_count, tree.span(id),
        elements ? "values in parentheses are no elements" : "values in parentheses are no vector");
    if (elements)
        problem.with_help("the elements of an array stand in braces: { 1, 2, 3 }");
    else if (word && context_.handlers.takes_braces(word->word))
        problem.with_help(
            message("a vector is written between `<` and `>`, and what belongs to "
                    "an object in braces: <1, 2, 3>, ",
                    context_.names.spelling(word->word), " { ... }"));
    else
        problem.with_help("a vector is written between `<` and `>`: <1, 2, 3>");
    context_.report(std::move(problem));
    return Absence::broken;
}

[[gnu::noinline]] Value Expressions::refuse_gap(const Tree& tree, NodeId id) {
    context_.report(error(Fault::syntax, tree.span(id), "two commas in a row")
                        .with_help("leave one out, or put the missing value between them"));
    return Absence::broken;
}

Value Expressions::walk_expression(const Tree& tree, NodeId id) {
    if (!context_.room(tree, id)) return Absence::broken;
    const NodeContent& content = tree[id].content;
    switch (content.index()) {
        case kind<node::Number>:
            return tree.numbers[std::get_if<node::Number>(&content)->number];
        case kind<node::Literal>: {
            const auto& literal = *std::get_if<node::Literal>(&content);
            Numbers numbers;
            numbers.count = static_cast<int>(literal.count);
            std::copy_n(tree.numbers.begin() + literal.first_number, literal.count,
                        numbers.at.begin());
            return numbers;
        }
        case kind<node::Text>:
            return tree.texts[std::get_if<node::Text>(&content)->text];
        case kind<node::Name>:
            context_.note_use(std::get_if<node::Name>(&content)->name, tree, id);
            return name_value(std::get_if<node::Name>(&content)->name, tree.span(id));
        case kind<node::Index>:
            return index_value(tree, *std::get_if<node::Index>(&content), id);
        case kind<node::Constant>:
            return constant(std::get_if<node::Constant>(&content)->word);
        case kind<node::Unary>:
            return unary(tree, *std::get_if<node::Unary>(&content), id);
        case kind<node::Binary>:
            return binary(tree, *std::get_if<node::Binary>(&content), id);
        case kind<node::Choice>:
            return choice(tree, *std::get_if<node::Choice>(&content));
        case kind<node::Chain>:
            return open_expression(tree, id);
        case kind<node::Group>:
            return group(tree, std::get_if<node::Group>(&content)->content, tree.span(id));
        case kind<node::Vector>:
            return vector(tree, *std::get_if<node::Vector>(&content), id);
        case kind<node::Member>:
            return member(tree, *std::get_if<node::Member>(&content), id);
        case kind<node::Call>:
            return context_.calls->call(tree, *std::get_if<node::Call>(&content), id);
        case kind<node::Prefixed>:
            return prefixed(tree, *std::get_if<node::Prefixed>(&content), id);
        case kind<node::Colour>:
            return colour(tree, *std::get_if<node::Colour>(&content), id);
        case kind<node::Array>:
            return array(tree, *std::get_if<node::Array>(&content), id);
        case kind<node::Function>:
            return context_.calls->function(tree, *std::get_if<node::Function>(&content), id);
        case kind<node::Apply>: {
            const auto& apply = *std::get_if<node::Apply>(&content);
            const Value called = evaluate(tree, apply.function);
            const NameId name = tree.get<node::Index>(apply.function).name;
            return context_.calls->call_value(tree, called, name, apply.arguments, tree.span(id));
        }
        case kind<node::Tuple>:
            return context_.awaited_tuple ? take_tuple(tree, id) : refuse_tuple(tree, id);
        case kind<node::Broken>:
            return Absence::broken;
        case kind<node::Omitted>:
            return refuse_gap(tree, id);
        default:
            return context_.statements->right_side(tree, id);
    }
}

Value Expressions::unary(const Tree& tree, const node::Unary& node, NodeId id) {
    if (node.sign != Operator::no && context_.calls->macro_call(tree, node.operand))
        return open_expression(tree, id);
    return with_sign(node.sign, evaluate(tree, node.operand), tree.span(id));
}

Value Expressions::with_sign(Operator sign, Value value, Span span) {
    if (value.broken()) return value;
    Numbers* numbers = value.edit_numbers();
    if (!numbers)
        return context_.broken(Fault::wrong_type, span,
                               message("`", candelabra::spelling(sign),
                                       "` takes numbers, but this is ", kind_name(value)));
    for (int i = 0; i < numbers->count && sign != Operator::plus; ++i) {
        double& x = numbers->at[static_cast<std::size_t>(i)];
        x = sign == Operator::minus ? -x : is_true(x) ? 0 : 1;
    }
    return value;
}

Value Expressions::binary(const Tree& tree, const node::Binary& node, NodeId id) {
    if (node.open) return open_expression(tree, id);
    Value left = evaluate(tree, node.left);
    Value right = evaluate(tree, node.right);
    return combine(node.sign, std::move(left), std::move(right), tree.span(node.right),
                   tree.span(id));
}

Value Expressions::combine(Operator sign, Value left, Value right, Span right_span, Span whole) {
    if (left.broken() || right.broken()) return Absence::broken;
    Numbers* a = left.edit_numbers();
    Numbers* b = right.edit_numbers();
    if (!a || !b) return truth(left, right, sign, whole);
    const int count = std::max(a->count, b->count);
    if (a->count < count) *a = a->promoted(count);
    if (b->count < count) *b = b->promoted(count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (sign == Operator::divide && b->at[i] == 0)
            context_.report(warning(Fault::division_by_zero, right_span,
                                    "division by zero; the result is infinite")
                                .with_label("this is 0"));
        a->at[i] = apply(sign, a->at[i], b->at[i]);
    }
    return left;
}

/// Applies an operator to operands that are not numbers: strings can be compared.
Value Expressions::truth(const Value& left, const Value& right, Operator sign, Span span) {
    if (left.text() && right.text() && is_comparison(sign)) {
        const int order = left.text()->compare(*right.text());
        return apply(sign, order, 0);
    }
    Diagnostic problem = error(Fault::wrong_type, span,
                               message("`", candelabra::spelling(sign), "` cannot join ",
                                       kind_name(left), " and ", kind_name(right)));
    if (left.text() && right.text() && sign == Operator::add)
        problem.with_help("strings are joined by concat(a, b)");
    else if ((left.text() && right.numbers()) || (left.numbers() && right.text()))
        problem.with_help("val(s) is the number in a string, str(x, 0, 2) is a number as a string");
    context_.report(problem);
    return Absence::broken;
}

/// Only one of the branches is evaluated; but in POV-Ray both are, so random streams advance for
/// both.
Value Expressions::choice(const Tree& tree, const node::Choice& node) {
    const std::optional<double> condition = number(tree, node.condition, "the condition of `? :`");
    if (!condition) return Absence::broken;
    const bool yes = is_true(*condition);
    if (!yes) draw(tree, node.yes);
    Value value = evaluate(tree, yes ? node.yes : node.no);
    if (yes) draw(tree, node.no);
    return value;
}

void Expressions::draw(const Tree& tree, NodeId id) {
    for (const NodeId call : random_calls(tree, id)) evaluate(tree, call);
}

std::vector<NodeId> Expressions::random_calls(const Tree& tree, NodeId id) const {
    std::vector<NodeId> calls;
    std::vector<NodeId> work = {id};
    const auto later = [&](std::initializer_list<NodeId> parts) {
        for (auto part = std::rbegin(parts); part != std::rend(parts); ++part)
            if (*part != no_node) work.push_back(*part);
    };
    const auto list = [&](NodeId first) {
        const std::size_t start = work.size();
        for (NodeId part = first; part != no_node; part = tree[part].next) work.push_back(part);
        std::reverse(work.begin() + static_cast<std::ptrdiff_t>(start), work.end());
    };
    while (!work.empty()) {
        const NodeId at = work.back();
        work.pop_back();
        if (const auto* call = tree.get_if<node::Call>(at)) {
            const bool random = context_.names.spelling(call->name) == "rand";
            random ? calls.push_back(at) : list(call->arguments);
        } else if (const auto* unary = tree.get_if<node::Unary>(at)) {
            later({unary->operand});
        } else if (const auto* binary = tree.get_if<node::Binary>(at)) {
            later({binary->left, binary->right});
        } else if (const auto* choice = tree.get_if<node::Choice>(at)) {
            later({choice->condition, choice->yes, choice->no});
        } else if (const auto* group = tree.get_if<node::Group>(at)) {
            list(group->content);
        } else if (const auto* vector = tree.get_if<node::Vector>(at)) {
            list(vector->components);
        } else if (const auto* member = tree.get_if<node::Member>(at)) {
            later({member->operand});
        } else if (const auto* index = tree.get_if<node::Index>(at)) {
            list(index->indices);
        } else if (const auto* prefixed = tree.get_if<node::Prefixed>(at)) {
            later({prefixed->operand});
        }
    }
    return calls;
}

Value Expressions::group(const Tree& tree, NodeId content, Span span) {
    // Nearly always there is only the value.
    if (content != no_node && tree[content].next == no_node && !tree.get_if<node::If>(content))
        return evaluate(tree, content);
    std::vector<Element> elements;
    context_.statements->walk(tree, content,
                              [&](const Element& element) { elements.push_back(element); });
    if (elements.size() > 1)
        if (const std::optional<Numbers> total = sum(elements, context_.sources)) return *total;
    return one_value(elements, span);
}

bool Expressions::components(const Tree& tree, NodeId first, std::vector<double>& result) {
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        const auto add = [&](const Value& value, Span span) {
            const Numbers* numbers = value.numbers();
            if (numbers && numbers->is_scalar()) {
                result.push_back(numbers->at[0]);
                return true;
            }
            if (!value.broken())
                context_.broken(Fault::wrong_type, span,
                                message("a component of a vector is a number, but this is ",
                                        kind_and_text(value)));
            return false;
        };
        const auto* call = tree.get_if<node::Call>(id);
        const bool macro = call && !context_.names.reserved(call->name) &&
                           !context_.calls->is_function(call->name);
        if (macro || Statements::is_directive(tree, id)) {
            // It may yield several components, or none.
            bool good = true;
            const auto take = [&](const Element& element) {
                good = good && add(context_.evaluator.value_of(element), element.span);
            };
            context_.statements->walk_one(tree, id, take);
            if (!good || context_.stopped()) return false;
        } else if (!add(evaluate(tree, id), tree.span(id))) {
            return false;
        }
    }
    return true;
}

Value Expressions::vector(const Tree& tree, const node::Vector& node, NodeId id) {
    std::vector<double> numbers;
    if (!components(tree, node.components, numbers)) return Absence::broken;
    return vector_of(numbers, tree.span(id));
}

Value Expressions::vector_of(const std::vector<double>& numbers, Span span) {
    if (numbers.size() < 2 || numbers.size() > 5)
        return context_.broken(
            Fault::wrong_count, span,
            message("a vector has 2 to 5 components, but this has ", numbers.size()));
    Numbers result;
    result.count = static_cast<int>(numbers.size());
    std::copy(numbers.begin(), numbers.end(), result.at.begin());
    return result;
}

Value Expressions::constant(NameId word) {
    const std::string_view name = context_.names.spelling(word);
    if (name == "x") return Numbers{{1, 0, 0}, 3};
    if (name == "y") return Numbers{{0, 1, 0}, 3};
    if (name == "z") return Numbers{{0, 0, 1}, 3};
    if (name == "u") return Numbers{{1, 0}, 2};
    if (name == "v") return Numbers{{0, 1}, 2};
    if (name == "t") return Numbers{{0, 0, 0, 1}, 4};
    if (name == "pi") return std::numbers::pi;
    if (name == "true" || name == "yes" || name == "on") return 1.0;
    if (name == "false" || name == "no" || name == "off") return 0.0;
    if (name == "clock") return context_.facts.clock;
    if (name == "clock_on") return context_.facts.clock_given ? 1.0 : 0.0;
    if (name == "version") return context_.version;
    // now: days since the year 2000 began, in UTC
    using namespace std::chrono;
    return duration<double, std::ratio<86400>>(system_clock::now() - sys_days(year(2000) / 1 / 1))
        .count();
}

Value Expressions::one_value(OneValue&& one, Span span) {
    if (one.broken || context_.stopped()) return Absence::broken;
    if (one.count == 1 && !one.first) return std::move(one.value);
    if (one.count != 1) return report_count(one.count, span);
    return one_value(
        one.first ? std::span<const Element>(&*one.first, 1) : std::span<const Element>(), span);
}

Value Expressions::report_count(std::size_t count, Span span) {
    if (count > 0)
        return context_.broken(Fault::wrong_count, span,
                               message("one value is wanted here, and this gives ", count));
    if (context_.stopped()) return Absence::broken;
    context_.report(error(Fault::missing, span, "a value is wanted here, and this macro gives none")
                        .with_help("a macro gives what stands in it without a directive: "
                                   "#macro Twice(A) (2*A) #end"));
    return Absence::broken;
}

Value Expressions::one_value(std::span<const Element> elements, Span span) {
    if (context_.stopped()) return Absence::broken;
    if (elements.empty())
        return context_.broken(Fault::missing, span, "a value is wanted here, and this gives none");
    const bool blocks = std::all_of(elements.begin(), elements.end(), [](const Element& e) {
        return e.kind == Element::Kind::block;
    });
    if (blocks) return context_.handlers.value(elements);
    for (const Element& element : elements)
        if (element.kind == Element::Kind::value && element.value.broken()) return Absence::broken;
    if (elements.size() > 1)
        return context_.broken(
            Fault::wrong_count, span,
            message("one value is wanted here, and this gives ", elements.size()));
    const Element& element = elements.front();
    switch (element.kind) {
        case Element::Kind::value:
            return element.value;
        case Element::Kind::word:
            if (!context_.names.reserved(element.word))
                return context_.unknown_name(element.word, element.span);
            return context_.broken(Fault::wrong_type, element.span,
                                   message("a value is wanted here, and `",
                                           context_.names.spelling(element.word), "` is none"));
        default:
            return context_.broken(Fault::wrong_type, element.span, "a value is wanted here");
    }
}

}  // namespace candelabra
