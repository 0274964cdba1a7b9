// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of angles of elementary.h. Angles are reduced by multiples of pi/2 as Cody and
// Waite (1980), and large ones as Payne and Hanek (1983) describe; the polynomials are minimax,
// found by Remez's algorithm.
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

constexpr Twofold half_turn{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Twofold quarter_turn{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// An angle as a number of quarter turns, of which the last two bits count, and a rest of at most
/// pi/4, or little more.
struct Reduced {
    std::uint64_t quarters;
    Twofold rest;
};

/// The bits of 2/pi, from 2^63 on; the first ones are 0.
constexpr std::array<std::uint64_t, 21> two_by_pi = {0,
                                                     0xa2f9836e4e441529,
                                                     0xfc2757d1f534ddc0,
                                                     0xdb6295993c439041,
                                                     0xfe5163abdebbc561,
                                                     0xb7246e3a424dd2e0,
                                                     0x06492eea09d1921c,
                                                     0xfe1deb1cb129a73e,
                                                     0xe88235f52ebb4484,
                                                     0xe99c7026b45f7e41,
                                                     0x3991d639835339f4,
                                                     0x9c845f8bbdf9283b,
                                                     0x1ff897ffde05980f,
                                                     0xef2f118b5a0a6d1f,
                                                     0x6d367ecf27cb09b7,
                                                     0x4f463f669e5fea2d,
                                                     0x7527bac7ebe5f17b,
                                                     0x3d0739f78a5292ea,
                                                     0x6bfb5fb11f8d5d08,
                                                     0x56033046fc7b6bab,
                                                     0xf0cfbc209af4361d};

/// a * b + carry: the low word; the high one is the next carry.
std::uint64_t multiplied(std::uint64_t a, std::uint64_t b, std::uint64_t& carry) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = static_cast<Wide>(a) * b + carry;
    carry = static_cast<std::uint64_t>(product >> 64);
    return static_cast<std::uint64_t>(product);
}

/// For any finite number of at least 1/2: 256 bits of the quotient by pi/2, of which those above
/// the last two whole ones are left out.
[[gnu::cold, gnu::noinline]] Reduced reduced_exactly(double size) {
    int exponent = 0;
    const double fraction = std::frexp(size, &exponent);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    const auto begin = static_cast<std::size_t>(exponent - 53 - 2 + 64);
    const std::size_t word = begin / 64, shift = begin % 64;
    std::array<std::uint64_t, 4> quotient{};  // the highest word first
    std::uint64_t carry = 0;
    for (std::size_t i = quotient.size(); i-- > 0;) {
        const std::uint64_t next = shift == 0 ? 0 : two_by_pi[word + i + 1] >> (64 - shift);
        quotient[i] = multiplied(two_by_pi[word + i] << shift | next, mantissa, carry);
    }
    std::uint64_t quarters = quotient[0] >> 62;
    for (std::size_t i = 0; i < 4; ++i)
        quotient[i] = quotient[i] << 2 | (i < 3 ? quotient[i + 1] >> 62 : 0);
    const bool beyond = quotient[0] >> 63 != 0;  // then counted back from the next quarter
    if (beyond) {
        ++quarters;
        for (std::uint64_t& part : quotient) part = ~part;
    }
    int zeros = 0;
    for (; quotient[0] >> 63 == 0 && zeros < 150; ++zeros)
        for (std::size_t i = 0; i < 4; ++i)
            quotient[i] = quotient[i] << 1 | (i < 3 ? quotient[i + 1] >> 63 : 0);
    const double high = static_cast<double>(quotient[0] >> 11) * 0x1p-53;
    const double low =
        static_cast<double>((quotient[0] & 0x7ff) << 42 | quotient[1] >> 22) * 0x1p-106;
    const Twofold rest = Twofold{high, low} * quarter_turn;
    const double scale = std::ldexp(beyond ? -1.0 : 1.0, -zeros);
    return {quarters, {rest.high * scale, rest.low * scale}};
}

/// For sizes of more than pi/4.
inline Reduced reduced(double size) {
    constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34;  // 33 bits each
    constexpr double third = 0x1.3198a2e037073p-69;
    constexpr double to_whole = 0x1.8p52;
    if (!(size < 0x1p20)) [[unlikely]]
        return reduced_exactly(size);
    const double shifted = size * 0x1.45f306dc9c883p-1 + to_whole, count = shifted - to_whole;
    const Twofold sum = exact_sum_of(size - count * first, -(count * second));
    const Twofold rest = exact_sum_of(sum.high, sum.low - count * third);
    if (std::abs(rest.high) < 0x1p-30) [[unlikely]]
        return reduced_exactly(size);
    return {std::bit_cast<std::uint64_t>(shifted), rest};
}

/// Sine and cosine of an angle, each as the sum of two numbers of which the second is small.
struct TwofoldSineCosine {
    Twofold sine, cosine;
};

/// For angles of at most pi/4, or little more.
inline TwofoldSineCosine near_sine_cosine(const Twofold& angle) {
    // Both polynomials at once: (sin x - x) / x^3, and (cos x - 1 + x^2 / 2) / x^4, of x^2.
    using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;
    constexpr Pair c0 = {-0.1666666666666663, 0.0416666666666666};
    constexpr Pair c1 = {0.008333333333322118, -0.0013888888888874138};
    constexpr Pair c2 = {-0.00019841269829589092, 2.4801587289491746e-05};
    constexpr Pair c3 = {2.7557313621240867e-06, -2.755731435520014e-07};
    constexpr Pair c4 = {-2.5050747741045514e-08, 2.087572367681216e-09};
    constexpr Pair c5 = {1.5896228923466164e-10, -1.1359669392559641e-11};
    const double x = angle.high, z1 = x * x, z2 = z1 * z1;
    const Pair z = {z1, z1}, zz = {z2, z2};
    const Pair p = (c0 + c1 * z) + zz * ((c2 + c3 * z) + zz * (c4 + c5 * z));
    const double half = 0.5 * z1, most = 1 - half;
    return {{x, x * z1 * p[0] + (angle.low - half * angle.low)},
            {most, ((1 - most) - half) + (z2 * p[1] - x * angle.low)}};
}

inline double sum_of(const Twofold& x) { return x.high + x.low; }

/// Changes the sign if the lowest bit of `odd` is set.
inline double signed_by(double x, std::uint64_t odd) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ odd << 63);
}

constexpr double nearest = 0.785398;  // less than pi/4

/// asin(x) = x + x * z * p(z), where z = x^2 <= 1/4; z * p(z).
inline double arcsine_tail(double z) {
    const double z2 = z * z, z4 = z2 * z2;
    const double a = (0.1666666666666676 + 0.07499999999970633 * z) +
                     z2 * (0.044642857174779116 + 0.030381942699375473 * z);
    const double b = (0.022372215234765576 + 0.017351607400918498 * z) +
                     z2 * (0.013980877827599995 + 0.011398427978611323 * z);
    const double c = (0.010783051369514657 + 0.003695528107004845 * z) +
                     z2 * (0.021734655134852822 - 0.021038581921546305 * z);
    return z * (a + z4 * (b + z4 * (c + z4 * 0.03265396020279786)));
}

/// acos(x) for x from 1/2 to 1: 2 asin(sqrt((1 - x) / 2)).
inline Twofold near_arccosine(double x) {
    const double z = 0.5 * (1 - x), root = std::sqrt(z), upper = upper_part(root);
    const double lost = root > 0 ? (z - upper * upper) / (root + upper) : 0;
    return {2 * upper, 2 * (lost + root * arcsine_tail(z))};
}

constexpr std::size_t arctangent_count = 33;

/// atan(i / 32), each from the one before.
constexpr std::array<Twofold, arctangent_count> arctangents_of() {
    std::array<Twofold, arctangent_count> values{};
    for (std::size_t i = 1; i < arctangent_count; ++i) {
        const Twofold step = Twofold{32, 0} / Twofold{static_cast<double>(1024 + i * (i - 1)), 0};
        const Twofold square = -(step * step);
        Twofold sum{0, 0};
        for (int n = 29; n > 0; n -= 2)
            sum = Twofold{1, 0} / Twofold{static_cast<double>(n), 0} + square * sum;
        values[i] = values[i - 1] + step * sum;
    }
    return values;
}

constexpr auto arctangents = arctangents_of();

/// base + sign * atan(small / large), where 0 <= small <= large, neither of which is extreme.
inline double arctangent(double small, double large, const Twofold& base, double sign) {
    constexpr double to_whole = 0x1.8p52;
    const double nearest_place = (small / large * 32 + to_whole) - to_whole;
    const double place = nearest_place < 2 ? 0 : nearest_place, known = place / 32;
    const Twofold& value = arctangents[static_cast<std::size_t>(place)];
    const double upper = upper_part(large);
    const double d = ((small - known * upper) - known * (large - upper)) / (large + known * small);
    const double z = d * d, z2 = z * z;
    const double tail =
        z * d *
        ((-0.3333333333333332 + 0.19999999999926993 * z) +
         z2 * ((-0.14285714138650019 + 0.11110981797303385 * z) + z2 * -0.09039262641884187));
    const Twofold sum = exact_sum_of(base.high, sign * value.high);
    const Twofold with = exact_sum_of(sum.high, sign * d);
    return with.high + (with.low + (sum.low + (base.low + sign * (value.low + tail))));
}

/// By ISO C, where an argument is 0, infinite or NaN, or where quotients would lose bits.
[[gnu::cold, gnu::noinline]] double special_atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const bool backwards = std::signbit(x);
    const double wide = std::abs(x), high = std::abs(y);
    if (high == 0) return std::copysign(backwards ? half_turn.high : 0, y);
    if (wide == 0) return std::copysign(quarter_turn.high, y);
    if (std::isinf(wide) && std::isinf(high))
        return std::copysign(backwards ? 3 * (0.25 * half_turn.high) : 0.5 * quarter_turn.high, y);
    if (std::isinf(high)) return std::copysign(quarter_turn.high, y);
    if (std::isinf(wide)) return std::copysign(backwards ? half_turn.high : 0, y);
    const double larger = wide > high ? wide : high, scale = larger > 1 ? 0x1p-100 : 0x1p200;
    if (!backwards && high < wide * 0x1p-60) return y / wide;
    return atan2(y * scale, x * scale);
}

}  // namespace

SineCosine sin_cos(double radians) {
    const double size = std::abs(radians);
    if (size < nearest) {
        const TwofoldSineCosine value = near_sine_cosine({radians, 0});
        return {sum_of(value.sine), sum_of(value.cosine)};
    }
    if (!(size < std::numeric_limits<double>::infinity())) [[unlikely]]
        return {radians - radians, radians - radians};
    const Reduced r = reduced(size);
    const TwofoldSineCosine value = near_sine_cosine(r.rest);
    const double a = sum_of(value.sine), b = sum_of(value.cosine);
    const bool swapped = (r.quarters & 1) != 0;
    return {signed_by(swapped ? b : a,
                      (r.quarters >> 1) ^ (std::bit_cast<std::uint64_t>(radians) >> 63)),
            signed_by(swapped ? a : b, (r.quarters >> 1) ^ r.quarters)};
}

double sin(double radians) { return radians == 0 ? radians : sin_cos(radians).sine; }

double cos(double radians) { return sin_cos(radians).cosine; }

double tan(double radians) {
    const double size = std::abs(radians);
    if (size < 0x1p-27) return radians;
    if (!(size < std::numeric_limits<double>::infinity())) return radians - radians;
    const Reduced r = size < nearest ? Reduced{0, {size, 0}} : reduced(size);
    const TwofoldSineCosine value = near_sine_cosine(r.rest);
    const Twofold a = ordered_sum(value.sine.high, value.sine.low);
    const Twofold b = ordered_sum(value.cosine.high, value.cosine.low);
    const double result = (r.quarters & 1) != 0 ? -(b / a).high : (a / b).high;
    return signed_by(result, std::bit_cast<std::uint64_t>(radians) >> 63);
}

double asin(double x) {
    const double size = std::abs(x);
    if (size <= 0.5) return x + x * arcsine_tail(x * x);
    if (!(size <= 1)) return std::numeric_limits<double>::quiet_NaN();
    const Twofold rest = near_arccosine(size);
    const Twofold sum = exact_sum_of(quarter_turn.high, -rest.high);
    return std::copysign(sum.high + (sum.low + (quarter_turn.low - rest.low)), x);
}

double acos(double x) {
    const double size = std::abs(x);
    if (size <= 0.5) {
        const Twofold sum = ordered_sum(quarter_turn.high, -x);
        return sum.high + (sum.low + (quarter_turn.low - x * arcsine_tail(x * x)));
    }
    if (!(size <= 1)) return std::numeric_limits<double>::quiet_NaN();
    const Twofold angle = near_arccosine(size);
    if (x > 0) return sum_of(angle);
    const Twofold sum = ordered_sum(half_turn.high, -angle.high);
    return sum.high + (sum.low + (half_turn.low - angle.low));
}

double atan(double x) { return atan2(x, 1); }

double atan2(double y, double x) {
    const double wide = std::abs(x), high = std::abs(y);
    const double larger = wide > high ? wide : high, smaller = wide > high ? high : wide;
    if (!(larger < 0x1p900 && smaller > 0x1p-900)) [[unlikely]]
        return special_atan2(y, x);
    // In eighths of the circle: the angle from the nearest axis, to or from which it counts.
    constexpr std::array<Twofold, 4> bases = {Twofold{0, 0}, quarter_turn, half_turn, quarter_turn};
    constexpr std::array<double, 4> signs = {1, -1, -1, 1};
    const std::size_t part = (high >= wide ? 1u : 0u) + (x < 0 ? 2u : 0u);
    return std::copysign(arctangent(smaller, larger, bases[part], signs[part]), y);
}

}  // namespace candelabra::math
