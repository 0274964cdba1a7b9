// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/julia_formula.h"

#include "base/complex.h"

#include <cmath>

namespace candelabra {

namespace {

/// F of complex numbers, by the formulas of the reproduced behaviour; NaN where it has no value (a
/// division by 0).
Complex value(const JuliaFractal& julia, const Complex& a) {
    constexpr Complex one{1, 0};
    switch (function_of(julia)) {
        case julia_exp:
            return exp(a);
        case julia_ln:
            return log(a);
        case julia_reciprocal:
            return one / a;
        case julia_sin:
            return sin(a);
        case julia_asin:
            return -1 * turned(log(turned(a) + sqrt(one - a * a)));
        case julia_sinh:
            return sinh(a);
        case julia_asinh:
            return log(a + sqrt(a * a + one));
        case julia_cos:
            return cos(a);
        case julia_acos:
            return -1 * turned(log(a + sqrt(a * a - one)));
        case julia_cosh:
            return cosh(a);
        case julia_acosh:
            return log(a + sqrt(a * a - one));
        case julia_tan:
            return tan(a);
        case julia_atan:
            return 0.5 * turned(log((one - turned(a)) / (one + turned(a))));
        case julia_tanh:
            return tanh(a);
        case julia_atanh:
            return 0.5 * log((one + a) / (one - a));
        default:
            break;
    }
    if (a == Complex{}) return {};
    const Complex power = Complex{julia.exponent.x, julia.exponent.y} * log(a);
    return power.re < -690 ? Complex{} : exp(power);
}

/// A hypercomplex number as two complex ones.
struct Halves {
    Complex a, b;

    explicit Halves(const Vec4& q) : a{q.x - q.w, q.y + q.z}, b{q.x + q.w, q.y - q.z} {}
    Halves(const Complex& first, const Complex& second) : a(first), b(second) {}

    Vec4 joined() const { return 0.5 * Vec4(a.re + b.re, a.im + b.im, a.im - b.im, b.re - a.re); }
};

Halves value(const JuliaFractal& julia, const Halves& q) {
    return {value(julia, q.a), value(julia, q.b)};
}

Halves product(const Halves& p, const Halves& q) { return {p.a * q.a, p.b * q.b}; }

}  // namespace

int function_of(const JuliaFractal& julia) {
    return julia.exponent == Vec2(0) ? julia.function : int{julia_pwr};
}

Vec4 formula_image(const JuliaFractal& julia, const Vec4& q) {
    const Vec4 result = value(julia, Halves(q)).joined();
    return std::isfinite(glm::dot(result, result)) ? result : q;
}

Vec3 formula_place(const JuliaFractal& julia, const Vec3& p) {
    return function_of(julia) == julia_reciprocal ? p : Vec3(p.x, p.y, p.y);
}

Vec3 formula_slope(const JuliaSet& set, const Vec3& point) {
    const JuliaFractal& julia = set.julia;
    const bool reciprocal = function_of(julia) == julia_reciprocal;
    Vec4 counted = set.place(formula_place(julia, point)), other = set.place(point);
    Halves derivative(counted);
    bool escaped = false;
    for (int n = 0; n < julia.max_iteration; ++n) {
        const Vec4& q = escaped ? other : counted;
        if (n > 0) {
            const Halves image = value(julia, Halves(q));
            derivative = product(derivative, image);
            if (reciprocal) derivative = product(derivative, Halves(-1 * image.a, -1 * image.b));
        }
        escaped = escaped || glm::dot(counted, counted) > set.limit2;
        if (!escaped) counted = formula_image(julia, counted) + julia.parameter;
        other = formula_image(julia, other) + julia.parameter;
    }
    const Halves last(escaped ? other : counted);
    const Vec4 slope =
        product(last, Halves(conjugate(derivative.a), conjugate(derivative.b))).joined();
    return Vec3(slope) - slope.w / set.slice.w * Vec3(set.slice);
}

}  // namespace candelabra
