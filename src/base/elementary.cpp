// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of nearby values and short polynomials (P. Tang, "Table-driven implementation of the
// exponential function", 1989, "... of the logarithm function", 1990). The tables follow from
// series while the program is compiled; the polynomials are minimax, found by Remez's algorithm.
// What would lose precision is carried as the sum of two numbers.
#include "base/elementary.h"

#include "base/twofold.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace candelabra::math {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr Twofold ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// Added and subtracted, it rounds small numbers to whole ones; they then are in the lowest bits.
constexpr double to_whole = 0x1.8p52;

constexpr std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }
constexpr double number_of(std::uint64_t bits) { return std::bit_cast<double>(bits); }

// The exponential function: 2^(k/128) from a table, times e^r with |r| < 1/369.

constexpr int power_bits = 7;
constexpr std::size_t power_count = std::size_t{1} << power_bits;

/// 2^(index / 128) as scale * (1 + tail); the bits of scale.
struct PowerOfTwo {
    std::uint64_t scale = 0;
    double tail = 0;
};

constexpr std::array<PowerOfTwo, power_count> powers_of_two() {
    std::array<PowerOfTwo, power_count> powers;
    for (std::size_t i = 0; i < power_count; ++i) {
        const Twofold x = ln2 * Twofold{static_cast<double>(i) / power_count, 0};
        Twofold sum{1, 0};
        for (int n = 22; n > 0; --n)
            sum = Twofold{1, 0} + x * sum / Twofold{static_cast<double>(n), 0};
        powers[i] = {bits_of(sum.high), sum.low / sum.high};
    }
    return powers;
}

constexpr auto powers = powers_of_two();

/// e^r * 2^(k/128) as scale * (1 + more).
struct Scaled {
    std::uint64_t scale;  ///< the bits of a number of any exponent, even an impossible one
    double more;
};

inline Scaled scaled_power(std::uint64_t k, double r) {
    const PowerOfTwo& power = powers[k % power_count];
    const double r2 = r * r;
    const double even = 0.49999999999996253 + 0.1666666666666613 * r;
    const double odd = 0.04166668197042065 + 0.008333335519583828 * r;
    return {power.scale + ((k - k % power_count) << (52 - power_bits)),
            power.tail + r + r2 * (even + r2 * odd)};
}

/// e^(x + tail) for |x| < 1000 and a tail that is small beside x.
inline Scaled scaled_exp(double x, double tail) {
    constexpr double inverse = 0x1.71547652b82fep+7;  // 128 / ln 2
    constexpr double step = 0x1.62e42fef8p-8, step_rest = 0x1.1cf79abc9e3b4p-43;
    const double shifted = x * inverse + to_whole, k = shifted - to_whole;
    return scaled_power(bits_of(shifted), ((x - k * step) - k * step_rest) + tail);
}

inline double product(const Scaled& s) {
    const double scale = number_of(s.scale);
    return scale + scale * s.more;
}

/// The product where it may overflow, or lose bits below the least normal number.
double far_product(Scaled s, bool large) {
    constexpr std::uint64_t far = std::uint64_t{600} << 52;
    s.scale = large ? s.scale - far : s.scale + far;
    return product(s) * (large ? 0x1p600 : 0x1p-600);
}

constexpr double far_exponent = 708;  // e^708 and its inverse are normal numbers

[[gnu::cold, gnu::noinline]] double far_exp(double x, double tail) {
    if (std::isnan(x)) return x;
    if (x > 710) return infinite;
    if (x < -746) return 0;
    return far_product(scaled_exp(x, tail), x > 0);
}

inline double exp_of(double x, double tail) {
    if (!(std::abs(x) < far_exponent)) [[unlikely]]
        return far_exp(x, tail);
    return product(scaled_exp(x, tail));
}

/// e^x for |x| < 708, to 60 bits.
inline Twofold twofold_exp(double x) {
    const Scaled s = scaled_exp(x, 0);
    const double scale = number_of(s.scale);
    return ordered_sum(scale, scale * s.more);
}

// The logarithm: x = 2^k z, log x = k ln 2 - log c + log(1 + r), where c from a table is about 1/z
// and has few bits, so that r = c z - 1 is exact as the sum of two.

constexpr int log_bits = 7;
constexpr std::size_t log_count = std::size_t{1} << log_bits;
/// Where z begins, at about 0.71. One interval has 1 within it, where c is 1.
constexpr std::uint64_t first_bits =
    0x3ff0000000000000 - (std::uint64_t{73} << 45) - 0x155555555555;

// Whole multiples of 2^-42, so that sums with up to 1075 of them are exact, and the rest.
constexpr Twofold ln2_parts{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45};

struct LogPoint {
    double inverse = 1;  ///< c, which has at most 26 bits
    double high = 0;     ///< -log(c): a multiple of 2^-42
    double low = 0;      ///< and the rest
};

/// log(x) for x from 0.5 to 2, by the series of artanh.
constexpr Twofold log_by_series(double x) {
    const Twofold s = exact_sum_of(x, -1) / exact_sum_of(x, 1), s2 = s * s;
    Twofold sum{0, 0};
    for (int n = 45; n > 0; n -= 2)
        sum = Twofold{1, 0} / Twofold{static_cast<double>(n), 0} + s2 * sum;
    sum = s * sum;
    return {2 * sum.high, 2 * sum.low};
}

constexpr std::array<LogPoint, log_count> log_points() {
    std::array<LogPoint, log_count> points;
    for (std::size_t i = 0; i < log_count; ++i) {
        const std::uint64_t begin = first_bits + (std::uint64_t{i} << (52 - log_bits));
        const std::uint64_t end = begin + (std::uint64_t{1} << (52 - log_bits));
        if (begin <= bits_of(1) && end > bits_of(1)) continue;
        const double inverse = upper_part(2 / (number_of(begin) + number_of(end)));
        const Twofold log = -log_by_series(inverse);
        const double high = (log.high + 0x1.8p10) - 0x1.8p10;
        points[i] = {inverse, high, (log.high - high) + log.low};
    }
    return points;
}

constexpr auto points = log_points();

/// The terms of a logarithm: high + (rest + log(1 + r)).
struct LogTerms {
    double high, rest;     ///< high is exact
    double first, second;  ///< r is the sum of these two, exactly
};

/// For the bits of a positive normal number; `more` is added to its binary exponent.
inline LogTerms log_terms(std::uint64_t bits, int more) {
    const std::uint64_t offset = bits - first_bits;
    const double k = static_cast<double>((static_cast<std::int64_t>(offset) >> 52) + more);
    const double z = number_of(bits - (offset & 0xfff0000000000000)), upper = upper_part(z);
    const LogPoint& point = points[(offset >> (52 - log_bits)) % log_count];
    return {k * ln2_parts.high + point.high, k * ln2_parts.low + point.low,
            upper * point.inverse - 1, (z - upper) * point.inverse};
}

/// (log(1 + r) - r + r^2 / 2) / r^3 for |r| < 1/250.
inline double log_tail(double r, double r2) {
    const double a = 0.3333333333333334 - 0.25000000000000006 * r;
    const double b = 0.19999999996542273 - 0.1666666666355471 * r;
    const double c = 0.14286074026843867 - 0.125003237671283 * r;
    return a + r2 * (b + r2 * c);
}

/// Whether the bits are those of a positive, finite, normal number.
inline bool is_plain(std::uint64_t bits) {
    return bits - 0x0010000000000000 < 0x7ff0000000000000 - 0x0010000000000000;
}

/// For numbers that are not plain: the logarithm, or a normal number in `scaled` that is 2^54 times
/// as large, and true.
bool is_subnormal(double x, double& scaled) {
    scaled = x * 0x1p54;
    return x > 0 && x < std::numeric_limits<double>::min();
}

/// The logarithm of what is neither normal and positive, nor subnormal and positive.
double special_log(double x) {
    if (x == 0) return -infinite;
    return x < 0 ? no_number : x;  // infinity, NaN
}

inline double plain_log(std::uint64_t bits, int more) {
    const LogTerms t = log_terms(bits, more);
    const Twofold exact = exact_sum_of(t.first, t.second);
    const double r = exact.high, r2 = r * r;
    const Twofold sum = ordered_sum(t.high, r);
    const double low = (t.rest + exact.low) + sum.low;
    return sum.high + (low + (r * r2 * log_tail(r, r2) - 0.5 * r2));
}

/// The logarithm of a positive normal number, to 68 bits.
inline Twofold twofold_log(std::uint64_t bits, int more) {
    const LogTerms t = log_terms(bits, more);
    const Twofold r = exact_sum_of(t.first, t.second);
    const Twofold r2 = exact_product(r.high, r.high);
    const Twofold one = ordered_sum(t.high, r.high), two = exact_sum_of(one.high, -0.5 * r2.high);
    const double third = r.high * r2.high * log_tail(r.high, r2.high);
    const double low = (t.rest + one.low) + (r.low - r.high * r.low) + two.low - 0.5 * r2.low;
    return ordered_sum(two.high, low + third);
}

Twofold twofold_log(double x) {
    double scaled = 0;
    if (is_subnormal(x, scaled)) return twofold_log(bits_of(scaled), -54);
    return twofold_log(bits_of(x), 0);
}

/// e^(log * exponent).
inline double power(const Twofold& log, const Twofold& exponent) {
    const Twofold product = exact_product(log.high, exponent.high);
    return exp_of(product.high, product.low + log.low * exponent.high + log.high * exponent.low);
}

bool is_whole(double x) { return std::trunc(x) == x; }
bool is_odd(double x) { return is_whole(x) && !is_whole(0.5 * x); }

/// By ISO C, where the base is no positive normal number, or the exponent is not finite.
[[gnu::cold, gnu::noinline]] double special_pow(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return base + exponent;
    const double size = std::abs(base);
    const bool negative = std::signbit(base) && is_odd(exponent);
    if (std::isinf(exponent)) {
        if (size == 1) return 1;
        return (size > 1) == (exponent > 0) ? infinite : 0;
    }
    if (size == 0 || std::isinf(size)) {
        const double result = (size == 0) == (exponent > 0) ? 0 : infinite;
        return negative ? -result : result;
    }
    if (base < 0 && !is_whole(exponent)) return no_number;
    const double result = pow(size, exponent);
    return negative ? -result : result;
}

/// e^size / 2 for size >= 700, or NaN.
double half_exp(double size) {
    if (!(size < 711)) return size > 0 ? infinite : size;
    Scaled s = scaled_exp(size, 0);
    s.scale -= std::uint64_t{1} << 52;
    return far_product(s, true);
}

/// sinh(x) for |x| <= 1.
double small_sinh(double x) {
    const double z = x * x;
    constexpr std::array<double, 7> c = {0.16666666666666669,    0.008333333333333139,
                                         0.00019841269841437678, 2.755731915533776e-06,
                                         2.5052123398440167e-08, 1.6057240348629903e-10,
                                         7.759312018575174e-13};
    double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = c[i] + z * sum;
    return x + x * z * sum;
}

/// e^x - 1 for |x| <= 0.35.
Twofold small_expm1(double x) {
    constexpr std::array<double, 11> c = {
        0.16666666666666666,    0.04166666666666668,    0.008333333333333338,
        0.0013888888888876076,  0.00019841269841247978, 2.480158734382784e-05,
        2.755731927483271e-06,  2.755725611677421e-07,  2.5052048991204275e-08,
        2.0920547759012525e-09, 1.609312242313928e-10};
    double sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = c[i] + x * sum;
    const Twofold square = exact_product(x, x), two = ordered_sum(x, 0.5 * square.high);
    return ordered_sum(two.high, two.low + (0.5 * square.low + x * square.high * sum));
}

/// e^x - 1 for |x| < 708, to 60 bits.
Twofold twofold_expm1(double x) {
    if (std::abs(x) <= 0.35) return small_expm1(x);
    const Twofold power = twofold_exp(x), sum = exact_sum_of(power.high, -1);
    return ordered_sum(sum.high, sum.low + power.low);
}

/// log(1 + x) for a sum of two numbers x > -1 that does not overflow.
double log_above_one(const Twofold& x) {
    const Twofold sum = exact_sum_of(1, x.high);
    const double rest = sum.low + x.low;
    if (sum.high == 1) return x.high + (x.low - 0.5 * x.high * x.high);
    const Twofold log = twofold_log(sum.high);
    return log.high + (log.low + rest / sum.high);
}

/// sqrt(x) to 100 bits, for x > 0.
Twofold twofold_root(const Twofold& x) {
    const double root = std::sqrt(x.high);
    const Twofold back = exact_product(root, root);
    return ordered_sum(root, ((x.high - back.high) - back.low + x.low) / (2 * root));
}

}  // namespace

double exp(double x) { return exp_of(x, 0); }

double exp2(double x) {
    if (std::isnan(x)) return x;
    if (x >= 1024) return infinite;
    if (x < -1076) return 0;
    constexpr double to_step = to_whole / power_count;
    const double shifted = x + to_step;
    const Scaled s = scaled_power(bits_of(shifted), (x - (shifted - to_step)) * ln2.high);
    return std::abs(x) < 1020 ? product(s) : far_product(s, x > 0);
}

double expm1(double x) {
    if (x == 0) return x;
    if (std::abs(x) < 700) return twofold_expm1(x).high;
    return exp(x) - 1;
}

double log(double x) {
    const std::uint64_t bits = bits_of(x);
    if (is_plain(bits)) [[likely]]
        return plain_log(bits, 0);
    double scaled = 0;
    return is_subnormal(x, scaled) ? plain_log(bits_of(scaled), -54) : special_log(x);
}

double log2(double x) {
    constexpr Twofold inverse{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
    if (!(x > 0) || std::isinf(x)) return special_log(x);
    return (twofold_log(x) * inverse).high;
}

double log10(double x) {
    constexpr Twofold inverse{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
    if (!(x > 0) || std::isinf(x)) return special_log(x);
    return (twofold_log(x) * inverse).high;
}

double log1p(double x) {
    if (x == 0 || !(x > -1) || std::isinf(x)) return x == 0 ? x : special_log(1 + x);
    return log_above_one({x, 0});
}

double pow(double base, double exponent) {
    const std::uint64_t bits = bits_of(base);
    if (!is_plain(bits) || !(std::abs(exponent) < 0x1p900)) [[unlikely]] {
        double scaled = 0;
        if (std::abs(exponent) < 0x1p900 && is_subnormal(base, scaled))
            return power(twofold_log(bits_of(scaled), -54), {exponent, 0});
        if (base > 0 && std::isfinite(base) && std::isfinite(exponent))
            return pow(base, std::copysign(0x1p899, exponent));
        return special_pow(base, exponent);
    }
    if (exponent == 2) return base * base;
    return power(twofold_log(bits, 0), {exponent, 0});
}

double cbrt(double x) {
    constexpr Twofold third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    if (x == 0 || !std::isfinite(x)) return x;
    return std::copysign(power(twofold_log(std::abs(x)), third), x);
}

double hypot(double x, double y) {
    x = std::abs(x);
    y = std::abs(y);
    const double larger = x > y ? x : y;
    if (larger < 0x1p500 && larger > 0x1p-400) [[likely]]
        return std::sqrt(x * x + y * y);
    if (std::isinf(x) || std::isinf(y)) return infinite;
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const double scale = larger > 1 ? 0x1p-600 : 0x1p600;
    return std::sqrt(x * scale * (x * scale) + y * scale * (y * scale)) / scale;
}

double sinh(double x) {
    const double size = std::abs(x);
    if (size <= 1) return small_sinh(x);
    if (!(size < 700)) return std::copysign(half_exp(size), x);
    const Twofold power = twofold_exp(size), inverse = Twofold{1, 0} / power;
    return std::copysign(0.5 * (power + -inverse).high, x);
}

double cosh(double x) {
    const double size = std::abs(x);
    if (!(size < 700)) return half_exp(size);
    const Twofold power = twofold_exp(size), inverse = Twofold{1, 0} / power;
    return 0.5 * (power + inverse).high;
}

double tanh(double x) {
    const double size = std::abs(x);
    if (x == 0 || std::isnan(x)) return x;
    if (size > 20) return std::copysign(1.0, x);
    const Twofold power = twofold_expm1(2 * size);
    return std::copysign((power / (power + Twofold{2, 0})).high, x);
}

double asinh(double x) {
    const double size = std::abs(x);
    if (x == 0 || !std::isfinite(x)) return x;
    if (size > 0x1p60) return std::copysign(log(size) + ln2.high, x);
    if (size < 0x1p-30) return x - x * x * x / 6;
    // log(x + sqrt(x^2 + 1)), with 1 taken out of the root.
    const Twofold square = exact_product(size, size);
    const Twofold more = square / (Twofold{1, 0} + twofold_root(Twofold{1, 0} + square));
    return std::copysign(log_above_one(Twofold{size, 0} + more), x);
}

double acosh(double x) {
    if (!(x >= 1)) return no_number;
    if (x > 0x1p60) return log(x) + ln2.high;
    if (x == 1) return 0;
    const Twofold t = exact_sum_of(x, -1);
    return log_above_one(t + twofold_root(t * exact_sum_of(x, 1)));
}

double atanh(double x) {
    const double size = std::abs(x);
    if (x == 0 || std::isnan(x)) return x;
    if (size > 1) return no_number;
    if (size == 1) return std::copysign(infinite, x);
    if (size < 0x1p-30) return x + x * x * x / 3;
    return std::copysign(0.5 * log_above_one(Twofold{2 * size, 0} / exact_sum_of(1, -size)), x);
}

}  // namespace candelabra::math
