// SPDX-License-Identifier: GPL-3.0-or-later
// A flat program on registers of doubles: what user functions and expressions are compiled to. Made
// by ProgramBuilder; it has no state, so any number of threads may execute one at the same time,
// each with its own registers.
#pragma once

#include "base/handle.h"
#include "formula/operation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra {

class Formula;

struct Instruction {
    Operation operation = Operation::end;
    std::uint16_t to = 0, a = 0, b = 0;
};
static_assert(sizeof(Instruction) == 8);

struct Program {
    static constexpr std::size_t max_results = 5;

    std::vector<Instruction> code = {{}};
    std::vector<double> constants;
    std::vector<Handle<Formula>> calls;
    std::size_t inputs = 0;
    std::size_t registers = 0;  ///< first the inputs, then the constants, then what is computed
    std::size_t results = 0;
    std::array<std::uint16_t, max_results> result{};  ///< the registers of the results

    /// Puts the constants where execute() wants them.
    void prepare(double* registers) const;
};

/// Inputs and constants must be in their registers. False when the program gave up: an operation
/// refused its operands, or a loop did not end. `passes`: of loops, its own and those of what it
/// calls, are added to it; there may be 100 million in all.
bool execute(const Program&, double* registers, std::uint32_t& passes);
inline bool execute(const Program& program, double* registers) {
    std::uint32_t passes = 0;
    return execute(program, registers, passes);
}

/// How many instructions an execution takes when no loop repeats, with all that is called; what is
/// beyond 2^62 counts as that.
std::uint64_t cost(const Program&);
/// And what each pass of a loop counts beside that, in the same steps.
inline constexpr std::uint64_t cost_of_pass = 10;

}  // namespace candelabra
