// SPDX-License-Identifier: GPL-3.0-or-later
// A linear program on registers of doubles, into which user functions and expressions are compiled.
// Made by ProgramBuilder. It has no state, so threads may execute it concurrently, each with its
// own registers.
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
    std::size_t registers = 0;  ///< the inputs, then the constants, then computed values
    std::size_t results = 0;
    std::array<std::uint16_t, max_results> result{};  ///< the registers of the results

    /// Stores the constants in the registers where execute() expects them.
    void prepare(double* registers) const;
};

/// Executes the program. Inputs and constants must be in their registers. Returns false if the
/// program failed: an operation refused its operands, or a loop did not end. Adds the passes of its
/// loops, and of those in functions that it calls, to `passes`; the limit is 100 million in all.
bool execute(const Program&, double* registers, std::uint32_t& passes);
inline bool execute(const Program& program, double* registers) {
    std::uint32_t passes = 0;
    return execute(program, registers, passes);
}

/// Number of instructions of an execution in which no loop repeats, including those of called
/// functions; at most 2^62.
std::uint64_t cost(const Program&);

}  // namespace candelabra
