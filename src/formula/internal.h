// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that POV-Ray 3.7 has built in and functions.inc gives names to: f_torus, f_heart,
// f_ridged_mf and their kin. Called by the compiler of `function { internal(n) }`. Pure, and
// defined for all arguments, though some give no number (NaN).
#pragma once

#include <span>
#include <string_view>

namespace candelabra {

struct InternalFunction {
    int number;  ///< n of internal(n)
    std::string_view name;
    int parameters;  ///< x, y, z and the extra ones
    double (*code)(const double* arguments);
};

/// The function of a number; null where there is none. (77 is not a function of numbers: it stands
/// for patterns.)
const InternalFunction* internal_function(int number);

/// All of them, by number.
std::span<const InternalFunction> internal_functions();

/// f_noise3d, which takes the scene's noise_generator. Its entry in the table takes generator 2.
inline constexpr int noise_function = 76;

}  // namespace candelabra
