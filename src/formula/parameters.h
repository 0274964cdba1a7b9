// SPDX-License-Identifier: GPL-3.0-or-later
// Common code of the internal functions: access to their arguments by name, and transformations of
// the point that many of them share. Included only by the files that define the functions.
#pragma once

#include "base/degrees.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace formula {

using std::numbers::pi;

constexpr double square(double t) { return t * t; }
constexpr double cube(double t) { return t * t * t; }

/// A point, its squared coordinates, and the parameters that follow it.
struct Parameters {
    explicit Parameters(const double* arguments)
        : x(arguments[0]), y(arguments[1]), z(arguments[2]), p(arguments + 3) {}

    double x, y, z;
    const double* p;
    double xx = x * x, yy = y * y, zz = z * z;

    double sum() const { return xx + yy + zz; }

    /// Returns the point at which to evaluate a plane curve in x and y. If p[first] is above 0, the
    /// curve is rotated in its plane by p[first + 2] degrees and then revolved about the y axis at
    /// distance p[first + 1].
    Parameters turned(int first) const {
        Parameters result = *this;
        if (!(p[first] > 0)) return result;
        const double away = std::sqrt(xx + zz) - p[first + 1];
        const double angle = p[first + 2] * radians_per_degree;
        result.x = away;
        if (angle != 0) {
            result.x = away * math::cos(angle) - y * math::sin(angle);
            result.y = away * math::sin(angle) + y * math::cos(angle);
        }
        result.xx = square(result.x);
        result.yy = square(result.y);
        return result;
    }
};

/// Clamps the value of a polynomial: large values far from the surface would only mislead the root
/// search.
inline double limited(double value) { return std::min(10.0, std::max(-10.0, value)); }

/// Distance from the origin by a norm whose unit circle is a square at 0, round at 1, and a star
/// beyond.
inline double cross_section(double u, double w, double shape) {
    if (shape == 1) return std::sqrt(u * u + w * w);
    const double a = std::abs(u), b = std::abs(w);
    if (shape == 0) return std::max(a, b);
    return math::pow(math::pow(a, 2 / shape) + math::pow(b, 2 / shape), shape / 2);
}

/// Returns the remainder of the division in [0, divisor).
inline double wrapped(double value, double divisor) {
    const double rest = std::fmod(value, divisor);
    return rest < 0 ? rest + divisor : rest;
}

}  // namespace formula

}  // namespace candelabra
