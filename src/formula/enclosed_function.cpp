// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/enclosed_function.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "base/infinity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

double square(double x) { return x * x; }

/// Returns the interval of absolute values.
Bounds size(const Bounds& a) {
    const double low = std::abs(a.low), high = std::abs(a.high);
    return {a.contains(0) ? 0 : std::min(low, high), std::max(low, high)};
}

using Code = double (*)(double);

/// Encloses a function that increases on its domain and whose derivative is monotonic in the
/// distance from 0.
Enclosure growing(const Enclosure& a, Code code, Code derivative, const Bounds& domain) {
    const bool cut = a.value.low < domain.low || a.value.high > domain.high;
    const Bounds within{std::max(a.value.low, domain.low), std::min(a.value.high, domain.high)};
    if (!(within.low <= within.high)) return Enclosure::unknown();
    const Bounds value{code(within.low), code(within.high)};
    if (cut) return {value, all_numbers};
    const Bounds far = size(within);
    double one = derivative(far.low), other = derivative(far.high);
    if (one > other) std::swap(one, other);
    return {value, Bounds{one, other} * a.slope};
}

Enclosure negated(const Enclosure& a) {
    return {{-a.value.high, -a.value.low}, {-a.slope.high, -a.slope.low}};
}

Enclosure plus(const Enclosure& a, double x) { return {a.value + Bounds{x, x}, a.slope}; }

Enclosure scaled(const Enclosure& a, double factor) {
    return {Bounds{factor, factor} * a.value, Bounds{factor, factor} * a.slope};
}

Enclosure stepped(const Enclosure& a, Code code) {
    const Bounds value{code(a.value.low), code(a.value.high)};
    return {value, value.single() ? Bounds{0, 0} : all_numbers};
}

/// Whether the range contains first + k * period for some integer k.
bool has_place(const Bounds& range, double first, double period) {
    constexpr double rounding = 1e-9;
    const double k = std::ceil((range.low - first) / period - rounding);
    return first + k * period <= range.high + rounding * period;
}

/// The cosines and sines of all angles in a range.
struct Circular {
    Bounds cosine{-1, 1}, sine{-1, 1};
};

Circular circular(const Bounds& a) {
    if (!(a.high - a.low < pi) || std::abs(a.low) > 1e9) return {};
    const double c1 = math::cos(a.low), s1 = math::sin(a.low);
    const double c2 = math::cos(a.high), s2 = math::sin(a.high);
    // In less than half a turn each has at most one extremum, which is where the other changes
    // sign.
    return {
        {s1 >= 0 && s2 <= 0 ? -1 : std::min(c1, c2), s1 <= 0 && s2 >= 0 ? 1 : std::max(c1, c2)},
        {c1 <= 0 && c2 >= 0 ? -1 : std::min(s1, s2), c1 >= 0 && c2 <= 0 ? 1 : std::max(s1, s2)}};
}

Enclosure absolute(const Enclosure& a) {
    if (a.value.low >= 0) return a;
    if (a.value.high <= 0) return negated(a);
    return {size(a.value), hull(a.slope, negated(a).slope)};
}

Enclosure arc_sine(const Enclosure& a) {
    return growing(
        a, [](double x) { return math::asin(x); },
        [](double x) { return 1 / std::sqrt(std::max(0.0, 1 - x * x)); }, {-1, 1});
}

Enclosure cosine(const Enclosure& a) {
    const Circular c = circular(a.value);
    return {c.cosine, Bounds{-c.sine.high, -c.sine.low} * a.slope};
}

Enclosure hyperbolic_cosine(const Enclosure& a) {
    const Bounds far = size(a.value);
    return {{math::cosh(far.low), math::cosh(far.high)},
            Bounds{math::sinh(a.value.low), math::sinh(a.value.high)} * a.slope};
}

Enclosure logarithm(const Enclosure& a) {
    return growing(
        a, [](double x) { return math::log(x); }, [](double x) { return 1 / x; }, {0, infinity});
}

Enclosure tangent(const Enclosure& a) {
    if (!(a.value.high - a.value.low < pi) || has_place(a.value, pi / 2, pi))
        return Enclosure::unknown();
    const Bounds value{math::tan(a.value.low), math::tan(a.value.high)};
    const Bounds far = size(value);
    return {value, Bounds{1 + square(far.low), 1 + square(far.high)} * a.slope};
}

// In the order of number_functions in operation.cpp.
constexpr auto enclosed_functions = std::array<Enclosure (*)(const Enclosure&), 22>{
    absolute,
    [](const Enclosure& a) { return plus(negated(arc_sine(a)), pi / 2); },
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::acosh(x); },
            [](double x) { return 1 / std::sqrt(x * x - 1); }, {1, infinity});
    },
    arc_sine,
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::asinh(x); },
            [](double x) { return 1 / std::sqrt(x * x + 1); }, all_numbers);
    },
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::atan(x); }, [](double x) { return 1 / (1 + x * x); },
            all_numbers);
    },
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::atanh(x); }, [](double x) { return 1 / (1 - x * x); },
            {-1, 1});
    },
    [](const Enclosure& a) { return stepped(a, [](double x) { return std::ceil(x); }); },
    cosine,
    hyperbolic_cosine,
    [](const Enclosure& a) { return scaled(a, 1 / radians_per_degree); },
    [](const Enclosure& a) {
        const Bounds value{math::exp(a.value.low), math::exp(a.value.high)};
        return Enclosure{value, value * a.slope};
    },
    [](const Enclosure& a) { return stepped(a, [](double x) { return std::floor(x); }); },
    [](const Enclosure& a) {
        if (!has_int32(a.value.low) || !has_int32(a.value.high)) return Enclosure::unknown();
        return stepped(a, [](double x) { return double(to_int32(x)); });
    },
    logarithm,
    [](const Enclosure& a) { return scaled(logarithm(a), 1 / math::log(10)); },
    [](const Enclosure& a) { return scaled(a, radians_per_degree); },
    [](const Enclosure& a) {
        const Circular c = circular(a.value);
        return Enclosure{c.sine, c.cosine * a.slope};
    },
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::sinh(x); }, [](double x) { return math::cosh(x); },
            all_numbers);
    },
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return std::sqrt(x); }, [](double x) { return 0.5 / std::sqrt(x); },
            {0, infinity});
    },
    tangent,
    [](const Enclosure& a) {
        return growing(
            a, [](double x) { return math::tanh(x); },
            [](double x) { return 1 - square(math::tanh(x)); }, all_numbers);
    },
};

}  // namespace

Enclosure enclosed_function(std::uint16_t number, const Enclosure& a) {
    return enclosed_functions[number](a);
}

}  // namespace candelabra
