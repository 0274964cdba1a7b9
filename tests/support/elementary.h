// SPDX-License-Identifier: GPL-3.0-or-later
// Compares functions of base/elementary.h with those of the C library for `long double`, whose errors
// do not count where it has more digits.
#pragma once

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace candelabra {

/// The distance in units in the last place of the right one.
inline double error_in_units(double result, long double right) {
    const double rounded = std::abs(static_cast<double>(right));
    const double least = std::numeric_limits<double>::denorm_min();
    const double unit = rounded < std::numeric_limits<double>::min()
                            ? least
                            : std::ldexp(1.0, std::ilogb(rounded) - 52);
    return static_cast<double>(std::abs(result - right) / static_cast<long double>(unit));
}

/// The greatest error at some thousands of places, many of them near 0.
template <class Right>
double worst_error(double (*f)(double), const Right& right, double from, double to) {
    double worst = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        double x = from + (to - from) * (static_cast<double>(mix(i) >> 11) * 0x1p-53);
        if (i % 8 == 0 && from <= 0) x = std::ldexp(x, -static_cast<int>(mix(~i) % 30));
        worst = std::max(worst, error_in_units(f(x), right(static_cast<long double>(x))));
    }
    return worst;
}

/// A range from which arguments are drawn.
struct ArgumentRange {
    double from, to;

    double at(std::uint64_t i) const {
        return from + (to - from) * (static_cast<double>(mix(i) >> 11) * 0x1p-53);
    }
};

/// Of a function of two numbers. Results that are no normal numbers do not count.
template <class Right>
double worst_error(double (*f)(double, double), const Right& right, ArgumentRange first,
                   ArgumentRange second) {
    double worst = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double x = first.at(2 * i), y = second.at(2 * i + 1), result = f(x, y);
        if (std::isnormal(result))
            worst = std::max(worst, error_in_units(result, right(static_cast<long double>(x),
                                                                 static_cast<long double>(y))));
    }
    return worst;
}

/// Whether both are NaN, or equal to a unit or two with the same sign.
inline bool agree(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (std::signbit(a) != std::signbit(b)) return false;
    return a == b || (std::isfinite(a) && std::isfinite(b) && error_in_units(a, b) <= 2);
}

}  // namespace candelabra
