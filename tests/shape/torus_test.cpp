// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/torus.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rays cross a torus where they should", "[shape]") {
    const Torus torus{2, 0.5};
    CHECK(answers(torus, {{-5.0 * x, x},
                          {{2.5, -x, true}, {3.5, x, false}, {6.5, -x, true}, {7.5, x, false}}}));
    CHECK(answers(torus, {{Vec3(2, 5, 0), -y}, {{4.5, y, true}, {5.5, -y, false}}}));
    CHECK(answers(torus, {{5.0 * y, -y}, {}}));
    CHECK(answers(torus, {{Vec3(-5, 0.5001, 0), x}, {}}));
    // Along the top of the ring the ray only touches it.
    CHECK(answers(torus, {{Vec3(-5, 0.5, 0), x}, {}}));
    CHECK(bounds(torus).high == Vec3(2.5, 0.5, 2.5));
    CHECK(bounds(torus).low == Vec3(-2.5, -0.5, -2.5));
}

TEST_CASE("hits of thin tori far away lie on them", "[shape]") {
    Draw draw(3);
    for (const double minor : {1e-3, 0.1, 0.9}) {
        const Torus torus{1, minor};
        for (int i = 0; i < 200; ++i) {
            const double turn = draw.between(0, 6.28);
            const Vec3 target(std::cos(turn), draw.between(-0.5, 0.5) * minor, std::sin(turn));
            const Vec3 origin = target + 1e3 * draw.direction();
            const auto found = hits(torus, {origin, target - origin});
            REQUIRE(found.size() >= 2);
            for (const Crossing& c : found) {
                const Vec3 p = origin + c.t * (target - origin);
                const double distance = std::hypot(std::hypot(p.x, p.z) - 1, p.y) - minor;
                CHECK(std::abs(distance) < 1e-11);
            }
        }
    }
}

TEST_CASE("a torus wider than its ring is met inside as well", "[shape]") {
    const Torus spindle{0.5, 1};
    CHECK(inside(spindle, o));
    CHECK(inside(spindle, Vec3(1.4, 0, 0)));
    const auto found = hits(spindle, {Vec3(0, 5, 0.01), -y});
    REQUIRE(found.size() == 4);
    CHECK(length(found[0].normal - Vec3(0, 0.8717, -0.49)) < 1e-4);
    CHECK(found[0].t == Approx(5 - 0.87172));
    CHECK(found[1].t == Approx(5 - 0.86017));
    CHECK(length(found[1].normal - unit(Vec3(0, 0.86017, 0.51))) < 1e-4);
    CHECK(hits(spindle, {-5.0 * x, x}).front().t == Approx(3.5));
}

TEST_CASE("words say what becomes of a torus's spindle", "[shape]") {
    Torus whole{0.5, 1}, merged = whole, hollow = whole, spindle = whole;
    whole.whole = merged.merged = hollow.hollow = spindle.spindle = true;
    const std::array all = {whole, merged, hollow, spindle};
    const std::array at_middle = {true, true, false, true}, beside = {true, true, true, false};
    const std::array counts = {4, 2, 4, 2};
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(inside(all[i], o) == at_middle[i]);
        CHECK(inside(all[i], Vec3(0.7, 0, 0)) == beside[i]);
        // A solid is where rays are between its surfaces.
        const Ray ray{Vec3(0.05, 5, 0.02), unit(Vec3(0, -1, 0.01))};
        const auto found = hits(all[i], ray);
        CHECK(found.size() == static_cast<std::size_t>(counts[i]));
        if (i == 0) continue;
        for (const Crossing& c : found) {
            CHECK(inside(all[i], ray.at(c.t + 1e-6)) == c.entering);
            CHECK(inside(all[i], ray.at(c.t - 1e-6)) != c.entering);
            CHECK((dot(c.normal, ray.direction) < 0) == c.entering);
        }
    }
    spindle.minor = 0.4;
    CHECK(vanishes(spindle) == "its tube covers nothing twice");
}

TEST_CASE("the inside of a torus is its tube", "[shape]") {
    const Torus torus{2, 0.5};
    CHECK(inside(torus, Vec3(2, 0.4, 0)));
    CHECK(inside(torus, Vec3(0, 0, -1.6)));
    CHECK_FALSE(inside(torus, o));
    CHECK_FALSE(inside(torus, Vec3(2, 0.6, 0)));
}

TEST_CASE("a torus around its own centre is a sphere", "[shape]") {
    CHECK(answers(Torus{0, 1}, {{Vec3(-5, 0, 0), x}, {{4, -x, true}, {6, x, false}}}));
    CHECK(inside(Torus{0, 1}, Vec3(0, 0.9, 0)));
}

}  // namespace candelabra
