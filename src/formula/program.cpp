// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/program.h"

#include "base/elementary.h"
#include "base/work_watch.h"
#include "formula/formula.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Limit on the passes of all loops in one execution, including those in called functions. No user
/// would wait for more, and a loop may be endless: sum(i, 1, 1e300, i).
constexpr std::uint32_t max_passes = 100'000'000;

}  // namespace

void Program::prepare(double* registers) const {
    std::copy(constants.begin(), constants.end(), registers + inputs);
}

bool execute(const Program& program, double* r, std::uint32_t& passes) {
    const Instruction* const code = program.code.data();
    const Instruction* at = code;
    using enum Operation;
    // One line for each operation.
    // clang-format off
    for (;;) {
        const Instruction i = *at++;
        switch (i.operation) {
            case copy: r[i.to] = r[i.a]; break;
            case add: r[i.to] = r[i.a] + r[i.b]; break;
            case subtract: r[i.to] = r[i.a] - r[i.b]; break;
            case multiply: r[i.to] = r[i.a] * r[i.b]; break;
            case divide: r[i.to] = r[i.a] / r[i.b]; break;
            case negate: r[i.to] = -r[i.a]; break;
            case less: r[i.to] = r[i.a] < r[i.b]; break;
            case less_equal: r[i.to] = r[i.a] <= r[i.b]; break;
            case equal: r[i.to] = r[i.a] == r[i.b]; break;
            case not_equal: r[i.to] = r[i.a] != r[i.b]; break;
            case greater_equal: r[i.to] = r[i.a] >= r[i.b]; break;
            case greater: r[i.to] = r[i.a] > r[i.b]; break;
            case both: r[i.to] = r[i.a] != 0 && r[i.b] != 0; break;
            case either: r[i.to] = r[i.a] != 0 || r[i.b] != 0; break;
            case about_less_equal: r[i.to] = r[i.a] <= r[i.b] || about(r[i.a], r[i.b]); break;
            case about_equal: r[i.to] = about(r[i.a], r[i.b]); break;
            case about_not_equal: r[i.to] = !about(r[i.a], r[i.b]); break;
            case about_greater_equal: r[i.to] = r[i.a] >= r[i.b] || about(r[i.a], r[i.b]); break;
            case true_both: r[i.to] = is_true(r[i.a]) && is_true(r[i.b]); break;
            case true_either: r[i.to] = is_true(r[i.a]) || is_true(r[i.b]); break;
            case not_true: r[i.to] = !is_true(r[i.a]); break;
            case least: r[i.to] = r[i.b] < r[i.a] ? r[i.b] : r[i.a]; break;
            case greatest: r[i.to] = r[i.b] > r[i.a] ? r[i.b] : r[i.a]; break;
            case power: r[i.to] = math::pow(r[i.a], r[i.b]); break;
            case arc_tangent: r[i.to] = math::atan2(r[i.a], r[i.b]); break;
            case remainder: r[i.to] = remainder_of(r[i.a], r[i.b]); break;
            case whole_quotient: r[i.to] = to_int32(r[i.a] / r[i.b]); break;
            case apply: r[i.to] = apply_function(i.b, r[i.a]); break;
            case divide_unless:
                if (r[i.b] == 0) return false;
                r[i.to] = r[i.a] / r[i.b];
                break;
            case refuse: if (r[i.a] != 0) return false; break;
            case jump: at = code + i.to; break;
            case jump_unless: if (!is_true(r[i.a])) at = code + i.to; break;
            case repeat:
                if (++passes > max_passes) return false;
                count_work(1);
                at = code + i.to;
                break;
            case call:
                if (!program.calls[i.a]->run(r + i.b, r + i.to, passes)) return false;
                break;
            case end: return true;
        }
    }
    // clang-format on
}

std::uint64_t cost(const Program& program) {
    constexpr std::uint64_t most = std::uint64_t{1} << 62;
    std::uint64_t sum = program.code.size();
    for (const Instruction& i : program.code)
        if (i.operation == Operation::call) sum = std::min(most, sum + program.calls[i.a]->cost());
    return sum;
}

}  // namespace candelabra
