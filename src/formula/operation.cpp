// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/operation.h"

#include "base/degrees.h"
#include "base/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

struct Named {
    std::string_view name;
    double (*code)(double);
};

constexpr auto number_functions = std::array{
    Named{"abs", [](double x) { return std::abs(x); }},
    Named{"acos", [](double x) { return math::acos(x); }},
    Named{"acosh", [](double x) { return math::acosh(x); }},
    Named{"asin", [](double x) { return math::asin(x); }},
    Named{"asinh", [](double x) { return math::asinh(x); }},
    Named{"atan", [](double x) { return math::atan(x); }},
    Named{"atanh", [](double x) { return math::atanh(x); }},
    Named{"ceil", [](double x) { return std::ceil(x); }},
    Named{"cos", [](double x) { return math::cos(x); }},
    Named{"cosh", [](double x) { return math::cosh(x); }},
    Named{"degrees", [](double x) { return x / radians_per_degree; }},
    Named{"exp", [](double x) { return math::exp(x); }},
    Named{"floor", [](double x) { return std::floor(x); }},
    Named{"int", [](double x) { return static_cast<double>(to_int32(x)); }},
    Named{"ln", [](double x) { return math::log(x); }},
    Named{"log", [](double x) { return math::log10(x); }},
    Named{"radians", [](double x) { return x * radians_per_degree; }},
    Named{"sin", [](double x) { return math::sin(x); }},
    Named{"sinh", [](double x) { return math::sinh(x); }},
    Named{"sqrt", [](double x) { return std::sqrt(x); }},
    Named{"tan", [](double x) { return math::tan(x); }},
    Named{"tanh", [](double x) { return math::tanh(x); }},
};

}  // namespace

std::optional<std::uint16_t> function_number(std::string_view name) {
    for (std::size_t i = 0; i < number_functions.size(); ++i)
        if (number_functions[i].name == name) return static_cast<std::uint16_t>(i);
    return std::nullopt;
}

std::optional<Operation> operation_of_two(std::string_view name) {
    if (name == "atan2") return Operation::arc_tangent;
    if (name == "div") return Operation::whole_quotient;
    if (name == "mod") return Operation::remainder;
    if (name == "pow") return Operation::power;
    return std::nullopt;
}

double apply_function(std::uint16_t number, double x) { return number_functions[number].code(x); }

std::int32_t to_int32(double value) {
    if (!has_int32(value)) return INT32_MIN;
    return static_cast<std::int32_t>(value);
}

double remainder_of(double a, double b) {
    constexpr double most = 4503599627370496.0;  // 2^52: the products below are exact
    if (!(std::abs(a) < most && std::abs(b) < most)) return std::fmod(a, b);
    const auto whole_a = static_cast<std::int64_t>(a);
    const auto whole_b = static_cast<std::int64_t>(b);
    if (static_cast<double>(whole_a) != a || static_cast<double>(whole_b) != b || b == 0)
        return std::fmod(a, b);
    const double size = std::abs(a), step = std::abs(b);
    // The rounded quotient of integers may exceed the true integer part by one, but not by more.
    double rest = size - static_cast<double>(static_cast<std::int64_t>(size / step)) * step;
    if (rest < 0) rest += step;
    return std::copysign(rest, a);
}

}  // namespace candelabra
