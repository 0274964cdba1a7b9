// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic operations of programs. User functions and the expressions of the language share
// one definition of each operation. Where the two differ, as in the tolerance of comparisons, there
// are two operations.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace candelabra {

/// The operation of an instruction. It writes register `to` and reads registers `a` and `b`, unless
/// stated otherwise.
enum class Operation : std::uint16_t {
    copy,  ///< copies a
    add,
    subtract,
    multiply,
    divide,  ///< by IEEE 754: x / 0 is infinite or NaN
    negate,
    less,  ///< comparisons yield 1 or 0
    less_equal,
    equal,
    not_equal,
    greater_equal,
    greater,
    both,  ///< whether neither is 0
    either,
    about_less_equal,  ///< comparisons that treat numbers closer than the tolerance as equal
    about_equal,
    about_not_equal,
    about_greater_equal,
    true_both,  ///< whether both are further from 0 than the tolerance
    true_either,
    not_true,
    least,
    greatest,
    power,
    arc_tangent,  ///< of a / b, in the quadrant of the point (b, a)
    remainder,
    whole_quotient,
    apply,          ///< applies function number b to a
    divide_unless,  ///< a / b; the program fails if b is 0
    refuse,         ///< the program fails unless a is 0
    jump,           ///< continues at instruction `to`
    jump_unless,    ///< jumps unless a is further from 0 than the tolerance
    repeat,         ///< jumps back to `to`; the program fails after very many repeats
    call,           ///< formula number a: arguments from register b on, results from `to` on
    end,
};

/// Numbers of the language that are closer than this compare equal, also to 0.
inline constexpr double tolerance = 1e-10;

inline bool is_true(double value) { return std::abs(value) > tolerance; }

/// Whether the numbers compare equal. As in POV-Ray, NaN equals every number.
inline bool about(double a, double b) { return a == b || !(std::abs(a - b) > tolerance); }

/// Whether the operation only computes a value: true of those before `divide_unless`.
constexpr bool only_computes(Operation operation) { return operation < Operation::divide_unless; }

/// Returns the number for Operation::apply of the function of one argument with this name in the
/// language. These functions have no side effects and yield NaN outside their domains (sqrt(-1)).
std::optional<std::uint16_t> function_number(std::string_view name);

/// Returns the operation for a function of two arguments: atan2, div, mod or pow.
std::optional<Operation> operation_of_two(std::string_view name);

/// Applies the function with this number. Precondition: function_number() returned the number.
double apply_function(std::uint16_t number, double x);

/// Whether the integer part of the value is a 32-bit integer.
constexpr bool has_int32(double value) { return value > -2147483649.0 && value < 2147483648.0; }
/// Converts to 32 bits, rounding towards zero. As in POV-Ray on x86, values out of range become the
/// least integer.
std::int32_t to_int32(double value);

/// Returns a - b * (a / b towards zero), exactly, with the sign of a. Equals std::fmod, but is fast
/// for integers.
double remainder_of(double a, double b);

}  // namespace candelabra
