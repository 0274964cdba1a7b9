// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere.h"

#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rays cross a sphere where they should", "[shape]") {
    const Sphere sphere{Vec3(1, 2, 3), 2};
    const std::vector<RayCase> table = {
        {{Vec3(1, 2, -10), Vec3(0, 0, 1)},
         {{11, Vec3(0, 0, -1), true}, {15, Vec3(0, 0, 1), false}}},
        {{Vec3(1, 2, -10), Vec3(0, 0, 1000)},
         {{0.011, Vec3(0, 0, -1), true}, {0.015, Vec3(0, 0, 1), false}}},
        {{Vec3(1, 2, 3), Vec3(1e-3, 0, 0)},
         {{-2000, Vec3(-1, 0, 0), true}, {2000, Vec3(1, 0, 0), false}}},
        {{Vec3(3, 2, 3), Vec3(1, 0, 0)}, {{-4, Vec3(-1, 0, 0), true}, {0, Vec3(1, 0, 0), false}}},
        {{Vec3(3, 2, 0), Vec3(0, 0, 1)}, {}},
        {{Vec3(9, 9, 9), Vec3(0, 0, 1)}, {}},
        {{Vec3(9, 9, 9), Vec3(0)}, {}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(sphere, table[i]));
    }
}

TEST_CASE("the surface of a sphere is not inside it", "[shape]") {
    const Sphere sphere{Vec3(1, 2, 3), 2};
    CHECK(inside(sphere, Vec3(1, 2, 3)));
    CHECK_FALSE(inside(sphere, Vec3(3, 2, 3)));
    CHECK(inside(sphere, Vec3(2.9, 2, 3)));
    CHECK(bounds(sphere).low == Vec3(-1, 0, 1));
    CHECK(bounds(sphere).high == Vec3(3, 4, 5));
}

TEST_CASE("spheres of all sizes are met at all distances", "[shape]") {
    Draw draw(1);
    for (const double radius : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        for (const double distance : {1e-3, 1.0, 1e3, 1e6}) {
            INFO("radius " << radius << " distance " << distance);
            for (int i = 0; i < 50; ++i) {
                const Sphere sphere{draw.point(distance), radius};
                const Vec3 target = sphere.centre + 0.9 * radius * draw.direction();
                const Vec3 origin = sphere.centre + (radius + distance) * draw.direction();
                const Ray ray{origin, std::exp(draw.between(-9, 9)) * (target - origin)};
                const std::vector<Crossing> found = hits(sphere, ray);
                REQUIRE(found.size() == 2);
                const double tolerance = 1e-13 * (radius + 10 * distance);
                for (const Crossing& c : found) {
                    CHECK(std::abs(length(ray.at(c.t) - sphere.centre) - radius) <= tolerance);
                    CHECK(length(ray.at(c.t) - sphere.centre - radius * c.normal) <=
                          10 * tolerance);
                }
                const double first = first_crossing(sphere.centre, radius, ray, Interval{});
                CHECK(std::abs(first - found[0].t) * length(ray.direction) <= 20 * tolerance);
            }
        }
}

TEST_CASE("the first crossing keeps to its range", "[shape]") {
    const Ray ray{Vec3(0, 0, -5), Vec3(0, 0, 1)};
    const auto first = [&](double min, double max) {
        return first_crossing(Vec3(0), 1, ray, Interval{min, max});
    };
    CHECK(first(0, 100) == 4);
    CHECK(first(4, 100) == 6);
    CHECK(first(6, 100) == 100);
    CHECK(first(0, 4) == 4);
    CHECK(first(0, 3) == 3);
    CHECK(first(5, 5.5) == 5.5);
}

TEST_CASE("the part of a sphere in a cell is bounded as closely as can be", "[shape]") {
    const Sphere sphere{Vec3(1, 2, 3), 5};
    const Box around = bounds(sphere);
    CHECK(clipped_bounds(sphere, around).low == around.low);
    CHECK(clipped_bounds(sphere, around).high == around.high);
    // Cells that the surface passes through, misses on the outside and contains.
    const Box cap = clipped_bounds(sphere, {Vec3(4, -9, -9), Vec3(9, 9, 9)});
    CHECK(cap.low.x == 4);
    CHECK(cap.high.x == Approx(6));
    CHECK(cap.low.y == Approx(-2));
    CHECK(cap.high.z == Approx(7));
    const Box pole = clipped_bounds(sphere, {Vec3(1, 2, 4), Vec3(4, 2, 12)});
    CHECK(pole.low.z == Approx(7));
    CHECK(pole.high.z == Approx(8));
    CHECK(clipped_bounds(sphere, {Vec3(0, 1, 2), Vec3(2, 3, 4)}).empty());
    CHECK(clipped_bounds(sphere, {Vec3(5, 6, 7), Vec3(6, 7, 8)}).empty());
    CHECK(clipped_bounds({sphere.centre, -sphere.radius}, around).high == around.high);
}

TEST_CASE("no point of a sphere is outside of its part in the cell", "[shape]") {
    Draw draw(31);
    for (int i = 0; i < 20000; ++i) {
        const double scale = std::pow(10, draw.between(-6, 6));
        const Sphere sphere{draw.point(scale), scale * draw.between(0.01, 1)};
        const Vec3 point = sphere.centre + sphere.radius * draw.direction();
        const Vec3 size = 0.3 * scale * (draw.point() + Vec3(1));
        const Vec3 low = point - size * (0.5 * (draw.point() + Vec3(1)));
        const Box part = clipped_bounds(sphere, {low, low + size});
        const Vec3 slack(4e-15 * scale);
        CHECK(contains({part.low - slack, part.high + slack}, point));
    }
}

}  // namespace candelabra
