// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/complex.h"

#include "base/elementary.h"

#include <cmath>

namespace candelabra {

Complex exp(Complex z) {
    const double size = math::exp(z.re);
    const auto [sine, cosine] = math::sin_cos(z.im);
    return {size * cosine, z.im == 0 ? z.im : size * sine};
}

Complex log(Complex z) {
    const double x = std::abs(z.re), y = std::abs(z.im);
    const double larger = std::fmax(x, y), smaller = std::fmin(x, y);
    // Near the unit circle, where the logarithm of the size is close to 0, without cancellation.
    const bool near = larger > 0.5 && larger < 1.5 && smaller < 1.5;
    const double size = near ? 0.5 * math::log1p((larger - 1) * (larger + 1) + smaller * smaller)
                             : math::log(math::hypot(x, y));
    return {size, math::atan2(z.im, z.re)};
}

Complex sqrt(Complex z) {
    if (z.re == 0 && z.im == 0) return {0, z.im};
    const double half = std::sqrt(0.5 * (std::abs(z.re) + math::hypot(z.re, z.im)));
    const double other = z.im / (2 * half);
    if (z.re >= 0) return {half, other};
    return {std::abs(other), std::copysign(half, z.im)};
}

Complex sin(Complex z) {
    const auto [sine, cosine] = math::sin_cos(z.re);
    return {sine * math::cosh(z.im), cosine * math::sinh(z.im)};
}

Complex cos(Complex z) {
    const auto [sine, cosine] = math::sin_cos(z.re);
    return {cosine * math::cosh(z.im), -sine * math::sinh(z.im)};
}

Complex tan(Complex z) {
    if (std::abs(z.im) > 20) return {0, std::copysign(1.0, z.im)};
    // tan x and tanh y, and by the theorem of addition the tangent of their sum.
    const double t = math::tan(z.re), h = math::tanh(z.im);
    const double divisor = 1 + t * t * h * h;
    return {t * (1 - h) * (1 + h) / divisor, h * (1 + t * t) / divisor};
}

Complex sinh(Complex z) {
    const Complex rotated = sin({-z.im, z.re});
    return {rotated.im, -rotated.re};
}

Complex cosh(Complex z) { return cos({-z.im, z.re}); }

Complex tanh(Complex z) {
    const Complex rotated = tan({-z.im, z.re});
    return {rotated.im, -rotated.re};
}

}  // namespace candelabra
