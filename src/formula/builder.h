// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a Program, instruction by instruction. Used by the compilers of expressions and of user
// functions. What is computed from constants alone is computed at once.
#pragma once

#include "formula/program.h"

#include <span>

namespace candelabra {

class ProgramBuilder {
public:
    /// A value of the program: an input, a constant, or a register that holds something computed.
    enum class Operand : std::uint16_t {};
    static constexpr Operand none{0xFFFF};

    /// One more input, behind those before.
    Operand input();
    Operand constant(double value);
    /// The value of a constant, or null.
    const double* known(Operand) const;

    /// A result in a register of its own, or a constant. Operations that only compute.
    Operand emit(Operation, Operand a, Operand b = none);
    /// Operation::apply.
    Operand apply(std::uint16_t function, Operand a);
    /// a / b where the program gives up when b is 0.
    Operand divide_unless(Operand a, Operand b);
    /// The program gives up unless the value is 0.
    void refuse(Operand);
    /// The first of the results, which are in registers that follow each other.
    Operand call(Handle<Formula>, std::span<const Operand> arguments);
    /// The register behind another, of results of a call.
    static Operand following(Operand first, std::size_t steps);

    // These take a list of values that nothing reads afterwards.
    /// The operation with the first two, with the result and the third, and so on. Not empty.
    Operand fold(Operation, std::span<const Operand>);
    /// v, a, b[, c] of select(). Three or four.
    Operand select(std::span<const Operand>);

    /// By repeated squaring, for exponents 0 to 8, as POV-Ray's functions do it.
    Operand whole_power(Operand base, int exponent);

    /// A register to be written by assign() and update().
    Operand variable();
    void assign(Operand variable, Operand value);
    /// variable = variable operation value
    void update(Operation, Operand variable, Operand value);

    /// A value is not read any more: its register may be used for others.
    void release(Operand);
    /// release() has no effect on the register until it is unpinned, which releases it.
    void pin(Operand);
    void unpin(Operand);

    /// Where the next instruction will be.
    std::size_t here() const { return code_.size(); }
    /// A jump forwards; land() says where it leads.
    std::size_t jump();
    std::size_t jump_unless(Operand condition);
    void land(std::size_t jump);
    void repeat(std::size_t from);

    /// False: it has too many instructions or registers, and there is no program.
    bool fits() const;
    /// Precondition: fits(), and at most Program::max_results results.
    Program finish(std::span<const Operand> results);

private:
    Operand fresh(std::size_t count);
    std::uint16_t place(std::uint16_t operand) const;

    std::vector<Instruction> code_;  ///< with operands instead of registers
    std::vector<double> constants_;
    std::vector<Handle<Formula>> calls_;
    enum class Use : std::uint8_t { none, once, pinned };
    std::vector<Use> used_;  ///< by register of something computed
    std::size_t inputs_ = 0;
};

}  // namespace candelabra
