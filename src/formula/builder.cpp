// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/builder.h"

#include "formula/formula.h"

#include <algorithm>
#include <bit>

namespace candelabra {

namespace {

// An operand is a kind in the two highest bits and a number; finish() maps it to a register.
constexpr std::uint16_t constant_kind = 0x4000;
constexpr std::uint16_t computed_kind = 0x8000;
constexpr std::uint16_t kind_bits = 0xC000;
constexpr std::size_t max_of_a_kind = 0x3000;

std::uint16_t bits(ProgramBuilder::Operand operand) { return static_cast<std::uint16_t>(operand); }

ProgramBuilder::Operand operand(std::uint16_t kind, std::size_t number) {
    return ProgramBuilder::Operand(kind | static_cast<std::uint16_t>(number & 0x3FFF));
}

/// Whether the operand `a` of the instruction is a register that it reads. Below, the same for `b`.
bool reads_a(Operation operation) {
    return operation != Operation::jump && operation != Operation::repeat &&
           operation != Operation::call && operation != Operation::end;
}

bool reads_b(Operation operation) {
    switch (operation) {
        case Operation::copy:
        case Operation::negate:
        case Operation::not_true:
        case Operation::apply:
        case Operation::refuse:
        case Operation::jump_unless:
            return false;
        default:
            return operation == Operation::call || reads_a(operation);
    }
}

bool writes(Operation operation) {
    return only_computes(operation) || operation == Operation::divide_unless ||
           operation == Operation::call;
}

}  // namespace

ProgramBuilder::Operand ProgramBuilder::input() { return operand(0, inputs_++); }

ProgramBuilder::Operand ProgramBuilder::constant(double value) {
    // Compare bits: -0 differs from 0, and NaN does not compare equal to itself.
    for (std::size_t i = 0; i < constants_.size(); ++i)
        if (std::bit_cast<std::uint64_t>(constants_[i]) == std::bit_cast<std::uint64_t>(value))
            return operand(constant_kind, i);
    constants_.push_back(value);
    return operand(constant_kind, constants_.size() - 1);
}

const double* ProgramBuilder::known(Operand value) const {
    const bool constant = value != none && (bits(value) & kind_bits) == constant_kind;
    return constant ? &constants_[bits(value) & 0x3FFF] : nullptr;
}

/// Allocates consecutive free registers.
ProgramBuilder::Operand ProgramBuilder::fresh(std::size_t count) {
    std::size_t first = 0, run = 0;
    for (std::size_t i = 0; i < used_.size() && run < count; ++i) {
        run = used_[i] != Use::none ? 0 : run + 1;
        first = i + 1 - run;
    }
    if (run == 0) first = used_.size();
    if (used_.size() < first + count) used_.resize(first + count);
    for (std::size_t i = first; i < first + count; ++i) used_[i] = Use::once;
    return operand(computed_kind, first);
}

ProgramBuilder::Operand ProgramBuilder::emit(Operation operation, Operand a, Operand b) {
    const bool one = !reads_b(operation);
    if (known(a) && (one || known(b)) && operation != Operation::copy) {
        Program program;
        program.code = {{operation, 2, 0, one ? bits(b) : std::uint16_t{1}}, {}};
        std::array<double, 3> registers = {*known(a), one ? 0 : *known(b), 0};
        execute(program, registers.data());
        return constant(registers[2]);
    }
    const Operand to = fresh(1);
    code_.push_back({operation, bits(to), bits(a), bits(b)});
    return to;
}

ProgramBuilder::Operand ProgramBuilder::apply(std::uint16_t function, Operand a) {
    return emit(Operation::apply, a, Operand(function));
}

ProgramBuilder::Operand ProgramBuilder::divide_unless(Operand a, Operand b) {
    if (known(b) && *known(b) != 0) return emit(Operation::divide, a, b);
    const Operand to = fresh(1);
    code_.push_back({Operation::divide_unless, bits(to), bits(a), bits(b)});
    return to;
}

void ProgramBuilder::refuse(Operand value) {
    if (known(value) && *known(value) == 0) return;
    code_.push_back({Operation::refuse, 0, bits(value), 0});
}

ProgramBuilder::Operand ProgramBuilder::call(Handle<Formula> formula,
                                             std::span<const Operand> arguments) {
    const std::size_t results = formula->results();
    const bool lone = arguments.size() == 1;  // read in place
    const std::size_t count = lone ? results : std::max(arguments.size(), results);
    const Operand first = fresh(count);
    for (std::size_t i = 0; i < arguments.size() && !lone; ++i)
        assign(following(first, i), arguments[i]);
    const auto number = static_cast<std::uint16_t>(calls_.size());
    calls_.push_back(std::move(formula));
    // The results may overwrite the arguments, which are not read any more.
    code_.push_back({Operation::call, bits(first), number, bits(lone ? arguments[0] : first)});
    for (std::size_t i = results; i < count; ++i) release(following(first, i));
    return first;
}

ProgramBuilder::Operand ProgramBuilder::following(Operand first, std::size_t steps) {
    return Operand(static_cast<std::uint16_t>(bits(first) + steps));
}

ProgramBuilder::Operand ProgramBuilder::variable() { return fresh(1); }

void ProgramBuilder::assign(Operand variable, Operand value) {
    code_.push_back({Operation::copy, bits(variable), bits(value), 0});
}

void ProgramBuilder::update(Operation operation, Operand variable, Operand value) {
    code_.push_back({operation, bits(variable), bits(variable), bits(value)});
}

void ProgramBuilder::release(Operand value) {
    if (value == none || (bits(value) & kind_bits) != computed_kind) return;
    Use& use = used_[bits(value) & 0x3FFF];
    if (use == Use::once) use = Use::none;
}

void ProgramBuilder::pin(Operand value) { used_[bits(value) & 0x3FFF] = Use::pinned; }
void ProgramBuilder::unpin(Operand value) { used_[bits(value) & 0x3FFF] = Use::none; }

ProgramBuilder::Operand ProgramBuilder::fold(Operation operation, std::span<const Operand> values) {
    Operand result = values[0];
    for (const Operand value : values.subspan(1)) {
        const Operand next = emit(operation, result, value);
        release(result);
        release(value);
        result = next;
    }
    return result;
}

ProgramBuilder::Operand ProgramBuilder::select(std::span<const Operand> values) {
    const Operand result = variable();
    std::vector<std::size_t> to_end;
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        const Operand here =
            emit(i == 1 ? Operation::less : Operation::equal, values[0], constant(0));
        const std::size_t other = jump_unless(here);
        release(here);
        assign(result, values[i]);
        to_end.push_back(jump());
        land(other);
    }
    assign(result, values.back());
    for (const std::size_t jump : to_end) land(jump);
    for (const Operand value : values) release(value);
    return result;
}

ProgramBuilder::Operand ProgramBuilder::whole_power(Operand base, int exponent) {
    if (exponent == 0) return constant(1);
    if (exponent == 1) return base;
    const Operand square = emit(Operation::multiply, base, base);
    Operand even = square;
    if (exponent >= 4) even = emit(Operation::multiply, square, square);
    if (exponent >= 6) {
        const Operand next = emit(Operation::multiply, even, exponent == 8 ? even : square);
        release(even);
        even = next;
    }
    if (even != square) release(square);
    if (exponent % 2 == 0) return even;
    const Operand odd = emit(Operation::multiply, even, base);
    release(even);
    return odd;
}

std::size_t ProgramBuilder::jump() {
    code_.push_back({Operation::jump, 0, 0, 0});
    return code_.size() - 1;
}

std::size_t ProgramBuilder::jump_unless(Operand condition) {
    code_.push_back({Operation::jump_unless, 0, bits(condition), 0});
    return code_.size() - 1;
}

void ProgramBuilder::land(std::size_t jump) {
    code_[jump].to = static_cast<std::uint16_t>(code_.size());
}

void ProgramBuilder::repeat(std::size_t from) {
    code_.push_back({Operation::repeat, static_cast<std::uint16_t>(from), 0, 0});
}

bool ProgramBuilder::fits() const {
    return code_.size() < 0xFFFF && inputs_ < max_of_a_kind && constants_.size() < max_of_a_kind &&
           used_.size() < max_of_a_kind && calls_.size() < max_of_a_kind;
}

/// Returns the register of an operand.
std::uint16_t ProgramBuilder::place(std::uint16_t operand) const {
    const std::size_t number = operand & 0x3FFF;
    const std::uint16_t kind = operand & kind_bits;
    const std::size_t before = kind == constant_kind   ? inputs_
                               : kind == computed_kind ? inputs_ + constants_.size()
                                                       : 0;
    return static_cast<std::uint16_t>(before + number);
}

Program ProgramBuilder::finish(std::span<const Operand> results) {
    Program program;
    program.inputs = inputs_;
    program.registers = inputs_ + constants_.size() + used_.size();
    program.results = results.size();
    for (std::size_t i = 0; i < results.size(); ++i) program.result[i] = place(bits(results[i]));
    program.code = std::move(code_);
    for (Instruction& instruction : program.code) {
        if (writes(instruction.operation)) instruction.to = place(instruction.to);
        if (reads_a(instruction.operation)) instruction.a = place(instruction.a);
        if (reads_b(instruction.operation)) instruction.b = place(instruction.b);
    }
    program.code.push_back({});
    program.constants = std::move(constants_);
    program.calls = std::move(calls_);
    return program;
}

}  // namespace candelabra
