// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/formula.h"

#include "base/long_work.h"

#include <algorithm>
#include <limits>

namespace candelabra {

namespace {

bool run_with(const Program& program, const double* arguments, double* results, double* registers,
              std::uint32_t& passes) {
    // Fast path for surfaces and patterns, the most frequent callers: calling a copy function would
    // take as long as the copy.
    if (program.inputs == 3) {
        registers[0] = arguments[0];
        registers[1] = arguments[1];
        registers[2] = arguments[2];
    } else {
        std::copy_n(arguments, program.inputs, registers);
    }
    program.prepare(registers);
    if (!execute(program, registers, passes)) return false;
    for (std::size_t i = 0; i < program.results; ++i) results[i] = registers[program.result[i]];
    return true;
}

bool run_program(const void* code, const double* arguments, double* results,
                 std::uint32_t& passes) {
    const Program& program = *static_cast<const Program*>(code);
    // Shorter ones count their loops only.
    constexpr std::size_t operations_of_step = 16;
    if (program.code.size() > operations_of_step)
        count_long_work(program.code.size() / operations_of_step);
    constexpr std::size_t usual = 64;
    if (program.registers > usual) {
        std::vector<double> registers(program.registers);
        return run_with(program, arguments, results, registers.data(), passes);
    }
    std::array<double, usual> registers;
    return run_with(program, arguments, results, registers.data(), passes);
}

}  // namespace

Formula::Formula(Program program)
    : parameters_(program.inputs), results_(program.results), run_(run_program) {
    written_ = true;
    cost_ = candelabra::cost(program);
    for (const auto& called : program.calls) {
        depth_ = std::max(depth_, called->depth() + 1);
        written_ = written_ && called->written();
    }
    code_ = std::make_shared<const Program>(std::move(program));
}

bool Formula::enclose(const Enclosure* arguments, Enclosure* results) const {
    if (run_ != run_program) return false;
    const Program& program = *static_cast<const Program*>(code_.get());
    constexpr std::size_t usual = 32;
    std::array<Enclosure, usual> few;
    std::vector<Enclosure> many(program.registers > usual ? program.registers : 0);
    Enclosure* const registers = many.empty() ? few.data() : many.data();
    std::copy_n(arguments, program.inputs, registers);
    if (!candelabra::enclose(program, registers)) return false;
    for (std::size_t i = 0; i < program.results; ++i) results[i] = registers[program.result[i]];
    return true;
}

double Formula::value(std::span<const double> arguments) const {
    FunctionResults results;
    return run(arguments.data(), results.data()) ? results[0]
                                                 : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace candelabra
