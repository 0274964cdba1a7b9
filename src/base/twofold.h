// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of twice the precision, as the sum of two, for the elementary functions. The formulas are
// those of Dekker (1971) and Knuth. They are right only if nothing is contracted to fused
// multiply-adds (CMakeLists.txt sees to it) and nothing overflows.
#pragma once

#include <bit>
#include <cstdint>

namespace candelabra {

/// high + low, where high is the sum rounded to nearest, unless stated otherwise.
struct Twofold {
    double high = 0, low = 0;
};

/// a + b exactly, if |a| >= |b| or a is 0.
constexpr Twofold ordered_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly.
constexpr Twofold exact_sum_of(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// x without its last 27 bits; products of two such numbers are exact.
constexpr double upper_part(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// a * b with an error of at most 2^-105 of it.
constexpr Twofold exact_product(double a, double b) {
    const double product = a * b;
    const double ah = upper_part(a), al = a - ah, bh = upper_part(b), bl = b - bh;
    return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

constexpr Twofold operator-(const Twofold& a) { return {-a.high, -a.low}; }

// Errors are at most some 2^-102 of the results; of sums, if the signs are equal.

constexpr Twofold operator+(const Twofold& a, const Twofold& b) {
    const Twofold sum = exact_sum_of(a.high, b.high);
    return ordered_sum(sum.high, sum.low + (a.low + b.low));
}

constexpr Twofold operator*(const Twofold& a, const Twofold& b) {
    const Twofold product = exact_product(a.high, b.high);
    return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

constexpr Twofold operator/(const Twofold& a, const Twofold& b) {
    const double quotient = a.high / b.high;
    const Twofold back = exact_product(quotient, b.high);
    const double rest = ((a.high - back.high) - back.low) + (a.low - quotient * b.low);
    return ordered_sum(quotient, rest / b.high);
}

}  // namespace candelabra
