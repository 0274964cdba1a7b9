// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/superellipsoid.h"

#include "shape/sphere.h"
#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

double value(const Vec2& e, const Vec3& p) {
    const double round = std::pow(std::abs(p.x), 2 / e.x) + std::pow(std::abs(p.y), 2 / e.x);
    return std::pow(round, e.x / e.y) + std::pow(std::abs(p.z), 2 / e.y) - 1;
}

}  // namespace

TEST_CASE("a superellipsoid is met where POV-Ray meets it", "[shape]") {
    const Superellipsoid s{{0.25, 0.5}};
    CHECK(inside(s, Vec3(0.9, 0.9, 0)));
    const Crossing a = hits(s, {Vec3(0.5, 0.3, -5), z}).at(0);
    CHECK(a.t == Approx(5 - 0.9839).margin(1e-4));
    CHECK(length(a.normal - Vec3(0.1291, 0.0036, -0.9916)) < 1e-4);
    const Crossing b = hits(s, {Vec3(-5, 0.3, 0.4), x}).at(0);
    CHECK(b.t == Approx(5 - 0.9935).margin(1e-4));
    CHECK(length(b.normal - Vec3(-0.9979, 0.0002, 0.0651)) < 1e-4);
}

TEST_CASE("round exponents make a sphere", "[shape]") {
    Draw draw(1);
    for (int i = 0; i < 500; ++i) {
        const Ray ray{draw.point(1.5), draw.between(0.1, 3) * draw.direction()};
        const auto expected = hits(Sphere{Vec3(0), 1}, ray),
                   found = hits(Superellipsoid{{1, 1}}, ray);
        REQUIRE(found.size() == expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            CHECK(found[k].t == Approx(expected[k].t).margin(1e-9));
            CHECK(length(found[k].normal - expected[k].normal) < 1e-8);
        }
    }
}

TEST_CASE("all signs that change along a ray are found, for exponents of any size", "[shape]") {
    Draw draw(2);
    for (const Vec2& e : {Vec2(0.1, 0.1), Vec2(0.02, 1), Vec2(1, 0.02), Vec2(2, 2), Vec2(0.5, 1.9),
                          Vec2(3, 3), Vec2(0.3, 4), Vec2(5, 0.5), Vec2(1, 3)})
        for (int i = 0; i < 100; ++i) {
            const Ray ray{draw.point(0.8), draw.direction()};
            // Changes counted in small steps, which may miss stretches that the ray only touches.
            int changes = 0;
            bool before = false;
            for (double t = -3; t < 3; t += 1e-3) {
                const bool now = value(e, ray.at(t)) < 0;
                changes += now != before;
                before = now;
            }
            const auto found = hits(Superellipsoid{e}, ray);
            INFO(e.x << ' ' << e.y << ' ' << i);
            CHECK(found.size() >= static_cast<std::size_t>(changes));
            for (const Crossing& c : found)
                CHECK(value(e, ray.at(c.t - 1e-7)) * value(e, ray.at(c.t + 1e-7)) < 0);
        }
}

}  // namespace candelabra
