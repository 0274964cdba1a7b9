// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_light.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

Vec2 place(std::uint32_t i) {
    Key key;
    key.sample = i;
    return {uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)};
}

/// A bright disc around the zenith, and a dim sky around it.
constexpr auto sun = [](const Vec3& direction) { return Rgb(direction.y > 0.98 ? 200 : 1); };

}  // namespace

TEST_CASE("a sky without light is still drawn from, evenly", "[backdrop]") {
    CHECK(SkyLight().empty());
    const SkyLight dark([](const Vec3&) { return Rgb(0); });
    REQUIRE_FALSE(dark.empty());
    for (std::uint32_t i = 0; i < 100; ++i) {
        const SkyLight::Drawn drawn = dark.draw(place(i));
        CHECK(length(drawn.direction) == Approx(1));
        CHECK(drawn.density == Approx(1 / (4 * pi)).epsilon(1e-3));
    }
}

TEST_CASE("the density of the sky's directions is 1 altogether", "[backdrop]") {
    const SkyLight sky(sun);
    double sum = 0;
    const int rows = 400, columns = 20;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double y = -1 + (i + 0.5) * 2 / rows, turn = 2 * pi * (j + 0.5) / columns;
            const double across = std::sqrt(1 - y * y);
            sum += sky.density({across * std::cos(turn), y, across * std::sin(turn)});
        }
    CHECK(sum * 4 * pi / (rows * columns) == Approx(1).epsilon(0.02));
}

TEST_CASE("directions are drawn where the sky is bright, without bias", "[backdrop]") {
    const SkyLight sky(sun);
    const int count = 4000;
    int bright = 0;
    double light = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const SkyLight::Drawn drawn = sky.draw(place(i));
        CHECK(drawn.density == Approx(sky.density(drawn.direction)));
        bright += drawn.direction.y > 0.98;
        light += sun(drawn.direction).r / drawn.density;
    }
    // The disc has 1 % of the directions and two thirds of the light.
    CHECK(bright > 0.5 * count);
    CHECK(light / count == Approx(4 * pi * (0.01 * 200 + 0.99)).epsilon(0.02));
}

}  // namespace candelabra
