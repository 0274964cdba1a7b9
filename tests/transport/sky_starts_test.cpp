// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_starts.h"

#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

TEST_CASE("starts of the sky's light are found where a room sees the sky", "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; camera { location <0, 1, -2> look_at <0, 1, 0> } difference { box { <-3.2, "
        "-0.2, -3.2>, <3.2, 3.2, 3.2> } box { <-3, 0, -3>, <3, 3, 3> } box { <2, 1, -1>, <4, 2.5, "
        "1> } pigment { rgb 0.8 } } plane { y, -0.2 pigment { rgb 0.3 } } sky_sphere { pigment { "
        "rgb 1 } luminaire }");
    const World& world = *shot.world;
    const std::vector<SkyStart> starts = sky_starts(world, seen_places(shot));
    REQUIRE(starts.size() > 100);
    for (const SkyStart& start : starts) {
        CHECK(start.worth > 0);
        const Vec3 direction = world.sky.light.draw(start.direction).direction;
        CAPTURE(start.place.x, start.place.y, start.place.z);
        if (start.place.x > 2.999 || start.place.y < -0.1) continue;
        // All light inside comes through the window.
        const Vec3 there = start.place + (3 - start.place.x) / direction.x * direction;
        CHECK(direction.x > 0);
        CHECK((there.y > 0.99 && there.y < 2.51 && std::abs(there.z) < 1.01));
    }
}

TEST_CASE("a guide draws rays about its starts, with the density that is stated", "[transport]") {
    const LitRegion region{.centre = Vec3(1, 0, 0), .radius = 2};
    const std::vector<SkyStart> starts = {{{0.1, 0.2}, Vec3(1, 1, 0), 1},
                                          {{0.15, 0.24}, Vec3(1.2, 1.1, 0.1), 3},
                                          {{0.9, 0.2}, Vec3(0, 40, 3), 2}};
    CHECK(SkyGuide().empty());
    const SkyGuide guide(starts, region, 4, 0.25);
    const Vec3 towards(0, 0, 1);
    Draw draw(2);
    // The mean of 1 over the density is the volume of what is drawn: two cells of the square times
    // the discs, of which two overlap.
    double left = 0, right = 0;
    int on_left = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const SkyGuide::Drawn drawn = guide.draw({draw.number(), draw.number()});
        CHECK((drawn.direction.y >= 0 && drawn.direction.y < 0.25));
        const Vec3 aside = guide.aside(drawn.near, towards, {draw.number(), draw.number()});
        const double density = guide.density(drawn.direction, towards, aside);
        REQUIRE(density > 0);
        const bool is_left = drawn.direction.x < 0.5;
        on_left += is_left;
        (is_left ? left : right) += 1 / density / count;
    }
    CHECK(on_left == Approx(4 * count / 6.0).epsilon(0.02));
    const double radius = 0.5, apart = std::hypot(0.2, 0.1), far = 0.25 * length(Vec3(-1, 40, 3));
    const double lens = 2 * radius * radius * std::acos(apart / (2 * radius)) -
                        apart / 2 * std::sqrt(4 * radius * radius - apart * apart);
    CHECK(left == Approx((2 * std::numbers::pi * radius * radius - lens) / 16).epsilon(0.01));
    CHECK(right == Approx(std::numbers::pi * far * far / 16).epsilon(0.01));
}

}  // namespace candelabra
