// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that POV-Ray 3.7 has built in and that functions.inc names: f_torus, f_heart,
// f_ridged_mf and others. Called by the compiler of `function { internal(n) }`. They are pure and
// defined for all arguments, though some results are NaN.
#pragma once

#include <span>
#include <string_view>

namespace candelabra {

struct InternalFunction {
    int number;  ///< n of internal(n)
    std::string_view name;
    int parameters;  ///< including x, y and z
    double (*code)(const double* arguments);
};

/// Returns the function of a number; null if there is none. (77 is not a function of numbers: it
/// stands for patterns.)
const InternalFunction* internal_function(int number);

/// Returns all internal functions, sorted by number.
std::span<const InternalFunction> internal_functions();

/// Number of f_noise3d, which uses the scene's noise_generator. Its table entry uses generator 2.
inline constexpr int noise_function = 76;

}  // namespace candelabra
