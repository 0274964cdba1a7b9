// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic that a program consists of. One meaning for each operation, shared by user
// functions and by the expressions of the language; where those two differ (what counts as equal),
// there are two operations.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace candelabra {

/// What an instruction does: `to` is the register that it writes, `a` and `b` are those it reads
/// unless something else is said.
enum class Operation : std::uint16_t {
    copy,  ///< of a
    add,
    subtract,
    multiply,
    divide,  ///< as IEEE 754 has it: x / 0 is infinite or not a number
    negate,
    less,  ///< comparisons give 1 or 0
    less_equal,
    equal,
    not_equal,
    greater_equal,
    greater,
    both,  ///< whether both are not 0
    either,
    about_less_equal,  ///< comparisons for which numbers closer than the tolerance are equal
    about_equal,
    about_not_equal,
    about_greater_equal,
    true_both,  ///< whether both are further from 0 than the tolerance
    true_either,
    not_true,
    least,
    greatest,
    power,
    arc_tangent,  ///< of a / b with the quadrant of the point (b, a)
    remainder,
    whole_quotient,
    apply,          ///< the function number b to a
    divide_unless,  ///< a / b, but the program gives up when b is 0
    refuse,         ///< the program gives up unless a is 0
    jump,           ///< goes on at instruction `to`
    jump_unless,    ///< the same unless a is further from 0 than the tolerance
    repeat,         ///< jumps back to `to`; the program gives up after very many of them
    call,           ///< formula number a: arguments from register b on, results from `to` on
    end,
};

/// Numbers of the language that are closer than this count as equal, and as 0.
inline constexpr double tolerance = 1e-10;

inline bool is_true(double value) { return std::abs(value) > tolerance; }

/// Whether they count as equal. As in POV-Ray, what is no number is as good as any.
inline bool about(double a, double b) { return a == b || !(std::abs(a - b) > tolerance); }

/// The operations that only compute: those before `divide_unless`.
constexpr bool only_computes(Operation operation) { return operation < Operation::divide_unless; }

/// The number of a function of one argument for Operation::apply, by its name in the language. None
/// gives anything but its value: where there is none (sqrt(-1)), that is not a number.
std::optional<std::uint16_t> function_number(std::string_view name);

/// The operation that a function of two arguments is: atan2, div, mod, pow.
std::optional<Operation> operation_of_two(std::string_view name);

/// The function with this number. Precondition: function_number() gave it.
double apply_function(std::uint16_t number, double x);

/// To 32 bits, towards zero, as POV-Ray's machine does it: what does not fit becomes the least
/// integer.
std::int32_t to_int32(double value);

/// a - b * (a / b towards zero), exactly, with the sign of a: std::fmod, but fast for whole
/// numbers.
double remainder_of(double a, double b);

}  // namespace candelabra
