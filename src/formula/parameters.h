// SPDX-License-Identifier: GPL-3.0-or-later
// What the internal functions share: their arguments by name, and the ways in which many of them
// prepare their point. Included by the files that define the functions, only.
#pragma once

#include "base/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace formula {

using std::numbers::pi;

constexpr double square(double t) { return t * t; }
constexpr double cube(double t) { return t * t * t; }

/// A point with its squares, and the parameters that follow it.
struct Parameters {
    explicit Parameters(const double* arguments)
        : x(arguments[0]), y(arguments[1]), z(arguments[2]), p(arguments + 3) {}

    double x, y, z;
    const double* p;
    double xx = x * x, yy = y * y, zz = z * z;

    double sum() const { return xx + yy + zz; }

    /// A curve of two dimensions in the plane x, y, or, if parameter `first` is above 0, that curve
    /// turned about the y axis at a distance (the next parameter), after a turn of its own by
    /// degrees (the one after it).
    Parameters turned(int first) const {
        Parameters result = *this;
        if (!(p[first] > 0)) return result;
        const double away = std::sqrt(xx + zz) - p[first + 1];
        const double angle = p[first + 2] * radians_per_degree;
        result.x = away;
        if (angle != 0) {
            result.x = away * std::cos(angle) - y * std::sin(angle);
            result.y = away * std::sin(angle) + y * std::cos(angle);
        }
        result.xx = square(result.x);
        result.yy = square(result.y);
        return result;
    }
};

/// Values of polynomials are cut off: far from the surface they would only mislead the search for
/// it.
inline double limited(double value) { return std::min(10.0, std::max(-10.0, value)); }

/// Distance from the origin by the norm whose unit circle goes from square (0) over round (1) to
/// star.
inline double cross_section(double u, double w, double shape) {
    if (shape == 1) return std::sqrt(u * u + w * w);
    const double a = std::abs(u), b = std::abs(w);
    if (shape == 0) return std::max(a, b);
    return std::pow(std::pow(a, 2 / shape) + std::pow(b, 2 / shape), shape / 2);
}

/// The remainder of a division, from 0 to below the divisor.
inline double wrapped(double value, double divisor) {
    const double rest = std::fmod(value, divisor);
    return rest < 0 ? rest + divisor : rest;
}

}  // namespace formula

}  // namespace candelabra
