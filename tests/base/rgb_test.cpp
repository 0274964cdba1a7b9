// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/rgb.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <concepts>
#include <type_traits>

namespace candelabra {

namespace {

template <class A, class B>
concept Mix = requires(A a, B b) {
    a + b;
}
|| requires(A a, B b) { a - b; }
|| requires(A a, B b) { a* b; }
|| requires(A a, B b) { a / b; }
|| requires(A a, B b) { a == b; }
|| requires(A a, B b) { dot(a, b); };

}  // namespace

TEST_CASE("light is no vector, and no vector is light", "[base]") {
    STATIC_REQUIRE_FALSE(std::is_constructible_v<Rgb, Vec3>);
    STATIC_REQUIRE_FALSE(std::is_constructible_v<Vec3, Rgb>);
    STATIC_REQUIRE_FALSE(std::is_convertible_v<double, Rgb>);
    STATIC_REQUIRE_FALSE(Mix<Rgb, Vec3>);
    STATIC_REQUIRE_FALSE(Mix<Vec3, Rgb>);
    CHECK(rgb_of(Vec3(1, 2, 3)) == Rgb(1, 2, 3));
    CHECK(vec3_of(Rgb(1, 2, 3)) == Vec3(1, 2, 3));
}

TEST_CASE("sums, products and quotients of light are those of vectors, to the bit", "[base]") {
    const Vec3 a(0.1, -2.3, 1e9), b(0.7, 0.3, -1.1);
    const Rgb c = rgb_of(a), d = rgb_of(b);
    CHECK(vec3_of(c + d) == a + b);
    CHECK(vec3_of(c - d) == a - b);
    CHECK(vec3_of(c * d) == a * b);
    CHECK(vec3_of(c / d) == a / b);
    CHECK(vec3_of(0.3 * c) == 0.3 * a);
    CHECK(vec3_of(c * 0.3) == a * 0.3);
    CHECK(vec3_of(c / 0.3) == a / 0.3);
    CHECK(vec3_of(-c) == -a);
    CHECK(vec3_of(math::exp(d)) == math::exp(b));
    CHECK(vec3_of(abs(c)) == glm::abs(a));
    CHECK(vec3_of(sqrt(abs(c))) == glm::sqrt(glm::abs(a)));
    CHECK(vec3_of(max(c, d)) == glm::max(a, b));
    CHECK(vec3_of(min(c, d)) == glm::min(a, b));
    CHECK(vec3_of(clamp(c, Rgb(-1), Rgb(1))) == glm::clamp(a, Vec3(-1), Vec3(1)));
    CHECK(vec3_of(mix(c, d, 0.3)) == glm::mix(a, b, 0.3));
    CHECK(max_component(c) == max_component(a));
    CHECK(min_component(c) == min_component(a));
    CHECK(max_abs_component(c) == max_abs_component(a));
    Rgb e = c;
    e /= e;
    CHECK(e == Rgb(1));
}

TEST_CASE("channels are red, green and blue, and 0 at first", "[base]") {
    Rgb light;
    CHECK(light == Rgb(0));
    for (int channel = 0; channel < 3; ++channel) light[channel] = channel + 1;
    CHECK(light == Rgb(1, 2, 3));
    CHECK(light.r == 1);
    CHECK(light.b == 3);
    CHECK(std::isnan(max(Rgb(NAN), Rgb(0)).g));
}

}  // namespace candelabra
