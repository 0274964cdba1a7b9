// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary functions whose results depend on their arguments alone. They use only operations that
// IEEE 754 defines to the last bit, so a picture is the same with every C library, processor and
// compiler; the C library's own versions differ between processors. They are the only ones that
// sources may use (a test in tests/house checks it). tests/bench/README.md compares them with other
// libraries.
//
// Errors are below 1 unit in the last place; those of atan2 and hypot below 1.4, of results below
// the least normal number 1.5. Special values are those of ISO C, Annex F. errno and the exceptions
// of floating-point numbers do not count. The rounding mode must be to nearest.
#pragma once

namespace candelabra::math {

struct SineCosine {
    double sine, cosine;
};

/// Takes no longer than one of the two.
[[gnu::const]] SineCosine sin_cos(double radians);

[[gnu::const]] double sin(double radians);
[[gnu::const]] double cos(double radians);
[[gnu::const]] double tan(double radians);
[[gnu::const]] double asin(double);
[[gnu::const]] double acos(double);
[[gnu::const]] double atan(double);
[[gnu::const]] double atan2(double y, double x);

[[gnu::const]] double exp(double);
[[gnu::const]] double exp2(double);
[[gnu::const]] double expm1(double);
[[gnu::const]] double log(double);
[[gnu::const]] double log2(double);
[[gnu::const]] double log10(double);
[[gnu::const]] double log1p(double);
[[gnu::const]] double pow(double base, double exponent);
[[gnu::const]] double cbrt(double);
[[gnu::const]] double hypot(double x, double y);

[[gnu::const]] double sinh(double);
[[gnu::const]] double cosh(double);
[[gnu::const]] double tanh(double);
[[gnu::const]] double asinh(double);
[[gnu::const]] double acosh(double);
[[gnu::const]] double atanh(double);

}  // namespace candelabra::math
