// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/fractal.h"

#include "base/complex.h"
#include "base/work_watch.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Returns the vocabulary of a fractal, with the words that all fractals share.
template <class T, class... F>
consteval auto described_fractal(std::string_view name, ItemText text, F... fields) {
    return schema<T>(
        name, text, fields...,
        Field<T>{
            "exterior", &T::exterior, item,
            "value outside: 0 factor, 1 share of iterations, 2 a, 3 b, 4 a^2, 5 b^2, 6 |a+bi|, "
            "7 and 8 iterations modulo the factor",
            between(0, 8)},
        Field<T>{"exterior_factor", &T::exterior_factor, following, "factor of the value outside"},
        Field<T>{"interior", &T::interior, item,
                 "value inside: 0 factor, 1 least |a+bi|, 2 a, 3 b, 4 a^2, 5 b^2, 6 a^2 + b^2",
                 between(0, 6)},
        Field<T>{"interior_factor", &T::interior_factor, following, "factor of the value inside"});
}

}  // namespace

const ItemInfo Mandel::vocabulary = described<Mandel>([] {
    using F = Field<Mandel>;
    return described_fractal<Mandel>(
        "mandel",
        {"The Mandelbrot set in the x-y plane.", "pigment { mandel 40 scale 0.5 }",
         "pigment { mandel 40 exponent 4 exterior 2, 1 interior 1, 1 scale 0.7 }"},
        F{"iterations", &Mandel::iterations, positional, "most steps of an orbit",
          between(0, max_iterations)},
        F{"exponent", &Mandel::exponent, item, "the power in z^n + c", between(2, 33)});
});

const ItemInfo JuliaPattern::vocabulary = described<JuliaPattern>([] {
    using F = Field<JuliaPattern>;
    return described_fractal<JuliaPattern>(
        "julia",
        {"A Julia set in the x-y plane.", "pigment { julia <0.353, 0.288>, 30 scale 0.7 }",
         "pigment { julia <0.353, 0.288>, 30 exponent 3 exterior 1, 1 interior 1, 1 scale 0.7 }"},
        F{"constant", &JuliaPattern::constant, positional, "c in z^n + c"},
        F{"iterations", &JuliaPattern::iterations, positional, "most steps of an orbit",
          between(0, max_iterations)},
        F{"exponent", &JuliaPattern::exponent, item, "the power in z^n + c", between(2, 33)});
});

const ItemInfo Magnet::vocabulary = described<Magnet>([] {
    using F = Field<Magnet>;
    return described_fractal<Magnet>(
        "magnet",
        {"A set from the theory of magnetism in the x-y plane.",
         "pigment { magnet 1 mandel 30 scale 0.3 }",
         "pigment { magnet 2 julia <0.3, 0.4>, 30 exterior 1, 1 interior 2, 1 scale 0.3 }"},
        F{"type", &Magnet::type, positional, "which of two formulas", between(1, 2)},
        F{"mandel", &Magnet::mandel, item, "orbits of 0; most steps of an orbit",
          between(0, max_iterations)},
        F{"julia", &Magnet::julia, item, "orbits of the point, with this constant"},
        F{"julia_iterations", &Magnet::julia_iterations, following, "most steps of an orbit",
          between(0, max_iterations)});
});

namespace {

Complex power(Complex z, int exponent) {
    Complex result = z;
    for (int i = 1; i < exponent; ++i) result = result * z;
    return result;
}

double exterior(const FractalColouring& colouring, int step, int steps, Complex z) {
    const double factor = colouring.exterior_factor;
    switch (colouring.exterior) {
        case 0:
            return factor;
        case 2:
            return z.re * factor;
        case 3:
            return z.im * factor;
        case 4:
            return z.re * z.re * factor;
        case 5:
            return z.im * z.im * factor;
        case 6:
            return std::sqrt(z.squared_size()) * factor;
        case 7:
            return std::fmod(step, std::floor(factor)) / factor;
        case 8:
            return std::fmod(step, std::floor(1 + factor)) / factor;
        default:
            return static_cast<double>(step) / steps;
    }
}

double interior(const FractalColouring& colouring, double least, Complex z) {
    const double factor = colouring.interior_factor;
    switch (colouring.interior) {
        case 1:
            return std::sqrt(least) * factor;
        case 2:
            return z.re * factor;
        case 3:
            return z.im * factor;
        case 4:
            return z.re * z.re * factor;
        case 5:
            return z.im * z.im * factor;
        case 6:
            // The factor applies to the second term only, as in POV-Ray.
            return z.re * z.re + z.im * z.im * factor;
        default:
            return factor;
    }
}

/// Follows an orbit until it escapes. `least` is the smallest squared modulus so far, and a step
/// takes so many products.
template <class Step, class Left>
double orbit(const FractalColouring& colouring, int steps, Complex z, double least, int products,
             Step next, Left left) {
    constexpr int steps_of_count = 8;
    for (int step = 0; step < steps; ++step) {
        if (step % steps_of_count == 0) count_work(static_cast<std::uint32_t>(products));
        z = next(z);
        if (left(z)) return exterior(colouring, step, steps, z);
        least = std::min(least, z.squared_size());
    }
    return interior(colouring, least, z);
}

template <class T>
double power_orbit(const T& kind, Complex start, Complex constant) {
    return orbit(
        kind, kind.iterations, start, start.squared_size(), kind.exponent - 1,
        [&](Complex z) { return power(z, kind.exponent) + constant; },
        [](Complex z) { return z.squared_size() > 4; });
}

Complex magnet_step(int type, Complex z, Complex c) {
    Complex above, below;
    if (type == 1) {
        above = z * z + c + -1;
        below = 2 * z + c + -2;
    } else {
        const Complex c1 = c + -1, c2 = c + -2;
        above = z * z * z + 3 * (c1 * z) + c1 * c2;
        below = 3 * (z * z) + 3 * (c2 * z) + c1 * c2 + 1;
    }
    const Complex ratio = above / below;
    return ratio * ratio;
}

}  // namespace

double evaluate(const Mandel& mandel, const Vec3& point) {
    const Complex start{point.x, point.y};
    return power_orbit(mandel, start, start);
}

double evaluate(const JuliaPattern& julia, const Vec3& point) {
    return power_orbit(julia, {point.x, point.y}, {julia.constant.x, julia.constant.y});
}

double evaluate(const Magnet& magnet, const Vec3& point) {
    const Complex at{point.x, point.y};
    const Complex constant = magnet.julia ? Complex{magnet.julia->x, magnet.julia->y} : at;
    const Complex start = magnet.julia ? at : Complex{};
    return orbit(
        magnet, magnet.julia ? magnet.julia_iterations : magnet.mandel, start,
        magnet.julia ? start.squared_size() : 10000, 4,
        [&](Complex z) { return magnet_step(magnet.type, z, constant); },
        [](Complex z) {
            return z.squared_size() > 10000 || (z + -1).squared_size() < 1.0 / 10000;
        });
}

}  // namespace candelabra
