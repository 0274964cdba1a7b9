// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/complex.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>

namespace candelabra {

namespace {

using Other = std::complex<double>;

void check_close(Complex result, const Other& right) {
    CHECK(result.re == Approx(right.real()).margin(1e-14));
    CHECK(result.im == Approx(right.imag()).margin(1e-14));
}

}  // namespace

TEST_CASE("functions of complex numbers are those of the standard library", "[complex]") {
    for (const double re : {-7.0, -1.2, -0.6, -0.0, 0.0, 1e-9, 0.4, 1.0, 3.0})
        for (const double im : {-5.0, -1.0, -0.0, 0.0, 1e-9, 0.7, 2.5, 30.0}) {
            INFO(re << " + " << im << " i");
            const Complex z{re, im};
            const Other w(re, im);
            check_close(exp(z), std::exp(w));
            check_close(sqrt(z), std::sqrt(w));
            check_close(sinh(z), std::sinh(w));
            check_close(cosh(z), std::cosh(w));
            check_close(tanh(z), std::tanh(w));
            check_close(tan(z), std::tan(w));
            check_close(1e-12 * sin(z), 1e-12 * std::sin(w));
            check_close(1e-12 * cos(z), 1e-12 * std::cos(w));
            if (w != 0.0) check_close(log(z), std::log(w));
            if (w != 0.0) check_close(Complex{2, 3} / z, Other(2, 3) / w);
            check_close(Complex{2, 3} * z, Other(2, 3) * w);
            check_close(turned(z), Other(0, 1) * w);
        }
}

TEST_CASE("the logarithm of a size close to 1 has all its digits", "[complex]") {
    const double angle = 0.4;
    const Complex z = (1 + 1e-10) * Complex{std::cos(angle), std::sin(angle)};
    CHECK(log(z).re == Approx(1e-10).epsilon(1e-5));
    CHECK(log({1, 1e-9}).re == Approx(0.5e-18));
}

}  // namespace candelabra
