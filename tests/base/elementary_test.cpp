// SPDX-License-Identifier: GPL-3.0-or-later
// Also of base/twofold.h, and of the functions of angles by their bits (see trigonometry_test.cpp).
#include "base/elementary.h"

#include "base/random.h"
#include "base/twofold.h"
#include "support/elementary.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

namespace candelabra {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A number that depends on every bit of the results for many arguments.
std::uint64_t digest(double (*f)(double)) {
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double share = static_cast<double>(mix(i) >> 11) * 0x1p-53;
        for (const double x : {share, 1 / share, -20 * share, 600 * share}) {
            const double y = f(x);
            sum = mix(sum ^ (std::isnan(y) ? 1 : std::bit_cast<std::uint64_t>(y)));
        }
    }
    return sum;
}

double with_itself(double (*f)(double, double), double x) { return f(std::abs(x), 0.7 - x / 9); }

}  // namespace

TEST_CASE("elementary functions have the same bits everywhere", "[elementary]") {
    // Whatever the C library, the processor and the compiler. A change of these numbers changes
    // pictures.
    CHECK(digest(math::sin) == 0xc6e4e5e40de5d5f6);
    CHECK(digest(math::cos) == 0x1c78710db30bb6c8);
    CHECK(digest(math::tan) == 0x4f5629762ef3ad84);
    CHECK(digest(math::asin) == 0xa45158a3f5c325c7);
    CHECK(digest(math::acos) == 0x407b257a7e775052);
    CHECK(digest(math::atan) == 0x82e14de407aa028b);
    CHECK(digest(math::exp) == 0x4283746247ea8e3e);
    CHECK(digest(math::exp2) == 0x2f5d2f2282efe6);
    CHECK(digest(math::expm1) == 0xda89d08a80109ba7);
    CHECK(digest(math::log) == 0x9bf5a7e94bbfba3);
    CHECK(digest(math::log2) == 0x72a9bd0e88ace034);
    CHECK(digest(math::log10) == 0x480a2ee66afece48);
    CHECK(digest(math::log1p) == 0xd817202767a80e2e);
    CHECK(digest(math::cbrt) == 0x2e1f6dc8d92728ec);
    CHECK(digest(math::sinh) == 0x10d90549ad66f00);
    CHECK(digest(math::cosh) == 0xb12e97f0566632a1);
    CHECK(digest(math::tanh) == 0xade9292920733bca);
    CHECK(digest(math::asinh) == 0x3ace8fa7e68df7b8);
    CHECK(digest(math::acosh) == 0xe6a3cfa3c7eccb92);
    CHECK(digest(math::atanh) == 0x52751a4a44e58eeb);
    CHECK(digest([](double x) { return with_itself(math::pow, x); }) == 0xfe76a7f99708ad45);
    CHECK(digest([](double x) { return with_itself(math::atan2, x); }) == 0x1541dd2d0808011c);
    CHECK(digest([](double x) { return with_itself(math::hypot, x); }) == 0x1b2339f17509beca);
}

TEST_CASE("exponential functions and logarithms are exact to about a unit", "[elementary]") {
    using L = long double;
    CHECK(worst_error(
              math::exp, [](L x) { return std::exp(x); }, -700, 700) < 0.6);
    CHECK(worst_error(
              math::exp, [](L x) { return std::exp(x); }, -745, -705) < 1.5);
    CHECK(worst_error(
              math::exp, [](L x) { return std::exp(x); }, 705, 709.7) < 0.6);
    CHECK(worst_error(
              math::exp2, [](L x) { return std::exp2(x); }, -1000, 1000) < 0.6);
    CHECK(worst_error(
              math::expm1, [](L x) { return std::expm1(x); }, -3, 3) < 0.7);
    CHECK(worst_error(
              math::expm1, [](L x) { return std::expm1(x); }, -1e-3, 1e-3) < 0.7);
    CHECK(worst_error(
              math::log, [](L x) { return std::log(x); }, 0, 3) < 0.6);
    CHECK(worst_error(
              math::log, [](L x) { return std::log(x); }, 0.99, 1.01) < 0.6);
    CHECK(worst_error(
              math::log, [](L x) { return std::log(x); }, 0, 1e300) < 0.6);
    CHECK(worst_error(
              math::log2, [](L x) { return std::log2(x); }, 0, 3) < 0.6);
    CHECK(worst_error(
              math::log10, [](L x) { return std::log10(x); }, 0, 3) < 0.6);
    CHECK(worst_error(
              math::log1p, [](L x) { return std::log1p(x); }, -1, 1) < 0.8);
    CHECK(worst_error(
              math::cbrt, [](L x) { return std::cbrt(x); }, -1000, 1000) < 0.6);
    CHECK(worst_error(
              math::sinh, [](L x) { return std::sinh(x); }, -5, 5) < 1);
    CHECK(worst_error(
              math::sinh, [](L x) { return std::sinh(x); }, -710.4, 710.4) < 1);
    CHECK(worst_error(
              math::cosh, [](L x) { return std::cosh(x); }, -710.4, 710.4) < 1);
    CHECK(worst_error(
              math::tanh, [](L x) { return std::tanh(x); }, -3, 3) < 0.7);
    CHECK(worst_error(
              math::asinh, [](L x) { return std::asinh(x); }, -30, 30) < 0.7);
    CHECK(worst_error(
              math::acosh, [](L x) { return std::acosh(x); }, 1, 30) < 0.7);
    CHECK(worst_error(
              math::atanh, [](L x) { return std::atanh(x); }, -1, 1) < 0.7);
}

TEST_CASE("powers and lengths are exact to about a unit", "[elementary]") {
    const auto power = [](long double x, long double y) { return std::pow(x, y); };
    CHECK(worst_error(math::pow, power, {0, 1}, {0, 100}) < 0.7);
    CHECK(worst_error(math::pow, power, {0, 1e10}, {-20, 20}) < 0.7);
    CHECK(worst_error(math::pow, power, {0.999, 1.001}, {-1e5, 1e5}) < 0.7);
    const auto length = [](long double x, long double y) { return std::hypot(x, y); };
    CHECK(worst_error(math::hypot, length, {-1, 1}, {-1, 1}) < 1.4);
    CHECK(worst_error(math::hypot, length, {-1e300, 1e300}, {0, 1e305}) < 1.4);
    CHECK(worst_error(math::hypot, length, {0, 1e-200}, {0, 1e-199}) < 1.4);
}

TEST_CASE("what is exact comes out exactly", "[elementary]") {
    for (int k = -1074; k < 1024; ++k) {
        const double power = std::ldexp(1.0, k);
        CHECK((math::exp2(k) == power && math::log2(power) == k && math::pow(2, k) == power));
    }
    double power = 1;
    for (int k = 0; k <= 22; ++k, power *= 10)
        CHECK((math::pow(10, k) == power && math::log10(power) == k));
    for (int k = 1; k < 1000; ++k) {
        CHECK(math::cbrt(-static_cast<double>(k) * k * k) == -k);
        CHECK(math::pow(static_cast<double>(k) * k, 0.5) == k);
        CHECK(math::hypot(3.0 * k, -4.0 * k) == 5.0 * k);
    }
    CHECK(math::exp(0) == 1);
    CHECK(math::log(1) == 0);
}

TEST_CASE("special values are those of ISO C", "[elementary]") {
    constexpr double tiny = 4.9e-324;
    for (const double x : {0.0, -0.0, 1.0, -1.0, 2.5, -3.0, tiny, -tiny, 1e308, infinite, -infinite,
                           none, 4503599627370497.0}) {
        INFO(x);
        CHECK(agree(math::exp(x), std::exp(x)));
        CHECK(agree(math::exp2(x), std::exp2(x)));
        CHECK(agree(math::expm1(x), std::expm1(x)));
        CHECK(agree(math::log(x), std::log(x)));
        CHECK(agree(math::log2(x), std::log2(x)));
        CHECK(agree(math::log10(x), std::log10(x)));
        CHECK(agree(math::log1p(x), std::log1p(x)));
        CHECK(agree(math::cbrt(x), std::cbrt(x)));
        CHECK(agree(math::sinh(x), std::sinh(x)));
        CHECK(agree(math::cosh(x), std::cosh(x)));
        CHECK(agree(math::tanh(x), std::tanh(x)));
        CHECK(agree(math::asinh(x), std::asinh(x)));
        CHECK(agree(math::acosh(x), std::acosh(x)));
        CHECK(agree(math::atanh(x), std::atanh(x)));
        for (const double y : {0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 2.0, 3.0, -3.0, tiny, 1e300, -1e300,
                               infinite, -infinite, none}) {
            INFO(y);
            CHECK(agree(math::pow(x, y), std::pow(x, y)));
            CHECK(agree(math::hypot(x, y), std::hypot(x, y)));
        }
    }
}

TEST_CASE("a sum of two numbers carries twice the digits", "[elementary]") {
    const Twofold third = Twofold{1, 0} / Twofold{3, 0};
    const Twofold one = third + third + third, ninth = third * third;
    CHECK((one.high == 1 && std::abs(one.low) < 0x1p-102));
    CHECK(std::abs((ninth.high * 9 - 1) + ninth.low * 9) < 0x1p-52);
    CHECK(std::abs((ninth * Twofold{9, 0} + Twofold{-1, 0}).high) < 0x1p-100);
    const Twofold product = exact_product(1 + 0x1p-40, 1 - 0x1p-50);
    CHECK(product.high + product.low == product.high);
    CHECK(((product.high - 1) - 0x1p-40) + 0x1p-50 + product.low == -0x1p-90);
}

}  // namespace candelabra
