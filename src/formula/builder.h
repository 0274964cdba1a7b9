// SPDX-License-Identifier: GPL-3.0-or-later
// Builds a Program, instruction by instruction, and folds constants. Used by the compilers of
// expressions and of user functions.
#pragma once

#include "formula/program.h"

#include <span>

namespace candelabra {

class ProgramBuilder {
public:
    /// A value in the program: an input, a constant, or a register that holds a computed value.
    enum class Operand : std::uint16_t {};
    static constexpr Operand none{0xFFFF};

    /// Appends an input.
    Operand input();
    Operand constant(double value);
    /// Returns the value of a constant operand; null for other operands.
    const double* known(Operand) const;

    /// Emits an operation for which only_computes() holds. Returns a fresh register with its
    /// result, or a constant if the operands are constants.
    Operand emit(Operation, Operand a, Operand b = none);
    /// Emits Operation::apply.
    Operand apply(std::uint16_t function, Operand a);
    /// Emits a / b; the program fails if b is 0.
    Operand divide_unless(Operand a, Operand b);
    /// Emits a check: the program fails unless the value is 0.
    void refuse(Operand);
    /// Emits a call. Returns the first of the results, which are in consecutive registers.
    Operand call(Handle<Formula>, std::span<const Operand> arguments);
    /// Returns the register `steps` after the first result of a call.
    static Operand following(Operand first, std::size_t steps);

    // These take values that are not read afterwards, and release them.
    /// Folds the values from the left with the operation. Precondition: at least one value.
    Operand fold(Operation, std::span<const Operand>);
    /// Emits select(v, a, b[, c]). Precondition: three or four values.
    Operand select(std::span<const Operand>);

    /// Emits a power by repeated squaring, as POV-Ray's functions do it. The exponent is 0 to 8.
    Operand whole_power(Operand base, int exponent);

    /// Returns a fresh register to be written by assign() and update().
    Operand variable();
    void assign(Operand variable, Operand value);
    /// Emits variable = variable operation value.
    void update(Operation, Operand variable, Operand value);

    /// Declares that a value is not read any more, so that its register may be reused.
    void release(Operand);
    /// Makes release() of the register ineffective until it is unpinned. Unpinning releases it.
    void pin(Operand);
    void unpin(Operand);

    /// Index of the next instruction.
    std::size_t here() const { return code_.size(); }
    /// Emits a forward jump and returns its index; land() sets its target to the next instruction.
    std::size_t jump();
    std::size_t jump_unless(Operand condition);
    void land(std::size_t jump);
    void repeat(std::size_t from);

    /// Whether the program has few enough instructions and registers to be finished.
    bool fits() const;
    /// Returns the program. Precondition: fits(), and at most Program::max_results results.
    Program finish(std::span<const Operand> results);

private:
    Operand fresh(std::size_t count);
    std::uint16_t place(std::uint16_t operand) const;

    std::vector<Instruction> code_;  ///< refer to operands instead of registers
    std::vector<double> constants_;
    std::vector<Handle<Formula>> calls_;
    enum class Use : std::uint8_t { none, once, pinned };
    std::vector<Use> used_;  ///< indexed by the number of a computed register
    std::size_t inputs_ = 0;
};

}  // namespace candelabra
