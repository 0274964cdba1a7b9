// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/number_functions.h"

#include "base/elementary.h"
#include "base/noise.h"
#include "base/transform.h"
#include "formula/operation.h"
#include "text/message.h"

#include <cmath>
#include <limits>

namespace candelabra {

namespace {

using Call = FunctionCall&;

Value clamped(Call call, double (*function)(double)) {
    const double x = call.number(0);
    if (std::isnan(x)) return x;
    if (std::abs(x) > 1)
        call.warn(Fault::domain, 0,
                  message("the argument is ", x, "; outside -1 to 1 the nearer end is taken"));
    return function(std::fmax(-1, std::fmin(1, x)));
}

Value logarithm(Call call, double (*function)(double)) {
    const double x = call.number(0);
    if (x <= 0) return call.fail(Fault::domain, 0, message("there is no logarithm of ", x));
    return function(x);
}

template <class F>
Value fold(Call call, F combine) {
    double result = call.number(0);
    for (std::size_t i = 1; i < call.count(); ++i) result = combine(result, call.number(i));
    return result;
}

template <class F>
Value fold_bits(Call call, F combine) {
    std::int32_t result = to_int32(call.number(0));
    for (std::size_t i = 1; i < call.count(); ++i)
        result = combine(result, to_int32(call.number(i)));
    return static_cast<double>(result);
}

}  // namespace

Value square_root(Call call) {
    const double x = call.number(0);
    if (x < 0) return call.fail(Fault::domain, 0, message("there is no square root of ", x));
    return std::sqrt(x);
}

Value arc_tangent(Call call) {
    const double y = call.number(0), x = call.number(1);
    if (std::abs(x) <= 1e-10 && std::abs(y) <= 1e-10 && !call.failed())
        return call.fail(Fault::domain, 2, "atan2(0, 0) has no direction");
    return math::atan2(y, x);
}

Value power(Call call) {
    const double base = call.number(0), exponent = call.number(1);
    if (base == 0 && exponent == 0 && !call.failed())
        return call.fail(Fault::domain, 2, "0 to the power of 0 has no value");
    return math::pow(base, exponent);
}

Value divide_whole(Call call) {
    return static_cast<double>(to_int32(call.number(0) / call.number(1)));
}

Value select(Call call) {
    const double v = call.number(0);
    if (call.count() == 3) return v < 0 ? call.number(1) : call.number(2);
    return v < 0 ? call.number(1) : v == 0 ? call.number(2) : call.number(3);
}

Value next_random(Call call) {
    const double stream = call.number(0);
    if (!call.world.random.known(stream))
        return call.fail(Fault::domain, 0,
                         message("there is no random stream ", stream, "; seed(...) gives one"));
    return call.world.random.next(static_cast<std::size_t>(stream));
}

Value normalised(Call call) {
    const Vec3 v = call.vector(0);
    if (v == Vec3(0)) {
        call.warn(Fault::domain, 0, "the zero vector has no direction; it stays zero");
        return Numbers::vector(v);
    }
    return Numbers::vector(v / length(v));
}

Value rotated_about(Call call) {
    const Vec3 axis = call.vector(1);
    if (axis == Vec3(0) && !call.failed()) {
        call.warn(Fault::domain, 1, "the zero vector is no axis; the result is no vector");
        return Numbers::vector(Vec3(-std::numeric_limits<double>::quiet_NaN()));
    }
    return Numbers::vector(Transform::rotation(axis, call.number(2)).direction(call.vector(0)));
}

Value arc_cosine(Call call) {
    return clamped(call, [](double x) { return math::acos(x); });
}

Value arc_sine(Call call) {
    return clamped(call, [](double x) { return math::asin(x); });
}

Value natural_logarithm(Call call) {
    return logarithm(call, [](double x) { return math::log(x); });
}

Value decimal_logarithm(Call call) {
    return logarithm(call, [](double x) { return math::log10(x); });
}

Value bits_and(Call call) {
    return fold_bits(call, [](auto a, auto b) { return a & b; });
}

Value bits_or(Call call) {
    return fold_bits(call, [](auto a, auto b) { return a | b; });
}

Value bits_xor(Call call) {
    return fold_bits(call, [](auto a, auto b) { return a ^ b; });
}

Value greatest(Call call) {
    return fold(call, [](double a, double b) { return b > a ? b : a; });
}

Value least(Call call) {
    return fold(call, [](double a, double b) { return b < a ? b : a; });
}

Value remainder(Call call) { return remainder_of(call.number(0), call.number(1)); }

Value new_random(Call call) { return static_cast<double>(call.world.random.open(call.number(0))); }

Value cross_product(Call call) { return Numbers::vector(cross(call.vector(0), call.vector(1))); }

Value dot_product(Call call) { return dot(call.vector(0), call.vector(1)); }

Value vector_length(Call call) { return length(call.vector(0)); }

Value vector_turbulence(Call call) {
    const Octaves octaves = {static_cast<int>(to_int32(call.number(2))),
                             static_cast<float>(call.number(1)),
                             static_cast<float>(call.number(0))};
    return Numbers::vector(turbulence(call.vector(3), octaves));
}

Value rotated(Call call) {
    return Numbers::vector(Transform::rotation(call.vector(1)).direction(call.vector(0)));
}

double to_integer(double x) { return to_int32(x); }

}  // namespace candelabra
