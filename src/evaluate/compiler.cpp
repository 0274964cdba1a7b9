// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/compiler.h"

#include <algorithm>

namespace {

/// Expressions that are nested deeper are walked: compiling takes room on the stack.
constexpr int most_depth = 500;

}  // namespace

OperatorCode operations_of(Operator sign) {
    using enum Operation;
    constexpr auto codes = std::array<OperatorCode, 12>{{
        {add, add},
        {subtract, subtract},
        {multiply, multiply},
        {divide_unless, divide},
        {less, less},
        {about_less_equal, less_equal},
        {about_equal, equal},
        {about_not_equal, not_equal},
        {about_greater_equal, greater_equal},
        {greater, greater},
        {true_both, both},
        {true_either, either},
    }};
    return codes[static_cast<std::size_t>(sign)];
}

Code* Evaluator::State::compile(const Tree& tree, NodeId id) {
    Code code;
    Compiler compiler(*this, tree, code);
    const Operands result = compiler.compile(id);
    if (result.count == 0 || !compiler.builder.fits()) return nullptr;
    code.program = compiler.builder.finish({result.at.data(), result.count});
    code.cost = cost(code.program);
    code.registers.resize(code.program.registers);
    code.program.prepare(code.registers.data());
    return codes.keep(tree, id, std::move(code));
}

Operands Evaluator::State::Compiler::compile(NodeId id) {
    if (++depth > most_depth) return {};
    const NodeContent& content = tree[id].content;
    const auto compiled = [&]() -> Operands {
        switch (content.index()) {
            case kind<node::Number>:
                return numbers({&tree.numbers[std::get_if<node::Number>(&content)->number], 1});
            case kind<node::Literal>: {
                const auto& literal = *std::get_if<node::Literal>(&content);
                return numbers({&tree.numbers[literal.first_number], literal.count});
            }
            case kind<node::Name>:
                return name(std::get_if<node::Name>(&content)->name);
            case kind<node::Index>:
                return index(*std::get_if<node::Index>(&content));
            case kind<node::Constant>:
                return constant(std::get_if<node::Constant>(&content)->word);
            case kind<node::Unary>:
                return unary(*std::get_if<node::Unary>(&content));
            case kind<node::Binary>:
                return binary(*std::get_if<node::Binary>(&content));
            case kind<node::Choice>:
                return choice(*std::get_if<node::Choice>(&content));
            case kind<node::Group>: {
                const NodeId only = std::get_if<node::Group>(&content)->content;
                return only == no_node || tree[only].next != no_node ? never() : compile(only);
            }
            case kind<node::Vector>:
                return vector(*std::get_if<node::Vector>(&content));
            case kind<node::Member>:
                return member(*std::get_if<node::Member>(&content));
            case kind<node::Prefixed>:
                return prefixed(*std::get_if<node::Prefixed>(&content));
            case kind<node::Call>:
                return call(*std::get_if<node::Call>(&content));
            default:
                return never();
        }
    }();
    --depth;
    // Nothing around such a node can be compiled either, and need not be tried again.
    if (hopeless) state.codes.exclude(tree, id);
    return compiled;
}

Operands Evaluator::State::Compiler::never() {
    hopeless = true;
    return {};
}

Operands Evaluator::State::Compiler::numbers(std::span<const double> values) {
    Operands result;
    for (const double value : values) result.at[result.count++] = builder.constant(value);
    return result;
}

Operands Evaluator::State::Compiler::name(NameId name) {
    for (const auto& [known, operands] : loaded)
        if (known == name) return operands;
    if (state.deprecated.contains(name)) return {};
    const Value* found = state.scope.find(name);
    const Numbers* numbers = found ? found->numbers() : nullptr;
    if (!numbers) return {};
    Operands result;
    result.count = static_cast<std::size_t>(numbers->count);
    for (std::size_t i = 0; i < result.count; ++i) result.at[i] = builder.input();
    const auto first = static_cast<std::uint16_t>(result.at[0]);  // inputs are the first registers
    code.inputs.push_back({name, first, static_cast<std::uint16_t>(result.count)});
    loaded.push_back({name, result});
    return result;
}

Operands Evaluator::State::Compiler::constant(NameId word) {
    const std::string_view name = state.names.spelling(word);
    if (name == "version" || name == "now") return never();  // they change
    const Value value = state.constant(word);
    return numbers({value.numbers()->at.data(), static_cast<std::size_t>(value.numbers()->count)});
}

Operands Evaluator::State::Compiler::promoted(const Operands& operands, std::size_t count) {
    if (operands.count != 1) return with_zeros(operands, count);
    Operands result;
    while (result.count < count) result.at[result.count++] = operands.at[0];
    return result;
}

Operands Evaluator::State::Compiler::with_zeros(const Operands& operands, std::size_t count) {
    Operands result = operands;
    while (result.count < count) result.at[result.count++] = builder.constant(0);
    return result;
}

void Evaluator::State::Compiler::release(const Operands& operands) {
    for (std::size_t i = 0; i < operands.count; ++i) builder.release(operands.at[i]);
}

void Evaluator::State::Compiler::refuse_unless(Operand condition) {
    const Operand opposite = builder.emit(Operation::equal, condition, builder.constant(0));
    builder.refuse(opposite);
    builder.release(opposite);
    builder.release(condition);
}

Operands Evaluator::State::Compiler::unary(const node::Unary& node) {
    const Operands operand = compile(node.operand);
    if (operand.count == 0 || node.sign == Operator::plus) return operand;
    const Operation operation =
        node.sign == Operator::minus ? Operation::negate : Operation::not_true;
    Operands result;
    for (; result.count < operand.count; ++result.count)
        result.at[result.count] = builder.emit(operation, operand.at[result.count]);
    release(operand);
    return result;
}

Operands Evaluator::State::Compiler::binary(const node::Binary& node) {
    const Operands left = compile(node.left);
    if (left.count == 0) return {};
    const Operands right = compile(node.right);
    if (right.count == 0) return {};
    const std::size_t count = std::max(left.count, right.count);
    const Operands a = promoted(left, count), b = promoted(right, count);
    const Operation operation = operations_of(node.sign).tolerant;
    Operands result;
    for (; result.count < count; ++result.count) {
        const Operand x = a.at[result.count], y = b.at[result.count];
        result.at[result.count] = operation == Operation::divide_unless
                                      ? builder.divide_unless(x, y)
                                      : builder.emit(operation, x, y);
    }
    release(left);
    release(right);
    return result;
}

/// Only one of the branches gives the value, but random streams advance as if both were computed,
/// the first before the second.
Operands Evaluator::State::Compiler::choice(const node::Choice& node) {
    const Operands condition = compile(node.condition);
    if (condition.count != 1) return {};
    const std::size_t to_no = builder.jump_unless(condition.at[0]);
    release(condition);
    const Operands yes = compile(node.yes);
    if (yes.count == 0 || !draw(node.no)) return {};
    Operands result;
    for (; result.count < yes.count; ++result.count) {
        result.at[result.count] = builder.variable();
        builder.assign(result.at[result.count], yes.at[result.count]);
    }
    release(yes);
    const std::size_t to_end = builder.jump();
    builder.land(to_no);
    if (!draw(node.yes)) return {};
    const Operands no = compile(node.no);
    if (no.count != result.count) return {};
    for (std::size_t i = 0; i < no.count; ++i) builder.assign(result.at[i], no.at[i]);
    release(no);
    builder.land(to_end);
    return result;
}

bool Evaluator::State::Compiler::draw(NodeId id) {
    for (const NodeId call : state.random_calls(tree, id)) {
        const Operands drawn = compile(call);
        if (drawn.count == 0) return false;
        release(drawn);
    }
    return true;
}

Operands Evaluator::State::Compiler::vector(const node::Vector& node) {
    Operands result;
    for (NodeId id = node.components; id != no_node; id = tree[id].next) {
        const Operands component = compile(id);
        if (component.count != 1) return {};
        if (result.count == result.at.size()) return never();
        result.at[result.count++] = component.at[0];
    }
    return result.count < 2 ? never() : result;
}

Operands Evaluator::State::Compiler::member(const node::Member& node) {
    const int part = component_of(state.names.spelling(node.member));
    if (part < 0) return never();
    const Operands operand = compile(node.operand);
    if (operand.count == 0) return {};
    if (part == grey_component) {
        const Operand grey = dot(numbers(grey_weights), with_zeros(operand, 3));
        release(operand);
        return Operands::one(grey);
    }
    if (part >= static_cast<int>(operand.count)) return {};
    const Operand result = operand.at[static_cast<std::size_t>(part)];
    for (std::size_t i = 0; i < operand.count; ++i)
        if (operand.at[i] != result) builder.release(operand.at[i]);
    return Operands::one(result);
}

Operands Evaluator::State::Compiler::prefixed(const node::Prefixed& node) {
    const std::string_view prefix = state.names.spelling(node.prefix);
    if (prefix.starts_with("s")) return never();  // sRGB needs more than arithmetic
    const std::string_view form = prefix.substr(3);
    const std::size_t wanted = form.empty() ? 3 : form == "ft" ? 5 : 4;
    const Operands given = compile(node.operand);
    if (given.count != 1 && given.count != wanted) return {};
    Operands result = with_zeros(promoted(given, wanted), 5);
    if (form == "t") std::swap(result.at[3], result.at[4]);
    return result;
}
