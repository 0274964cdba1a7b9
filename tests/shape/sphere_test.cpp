// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere.h"

#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

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

TEST_CASE("clipped bounds of a sphere hold its surface in the cell, and little more", "[shape]") {
    Draw draw(2);
    int empty = 0, small = 0;
    for (int i = 0; i < 300; ++i) {
        const double scale = std::pow(10, draw.between(-6, 6));
        const Sphere sphere{scale * draw.point(3), scale};
        const Vec3 a = sphere.centre + scale * draw.point(1.2),
                   b = sphere.centre + scale * draw.point(1.2);
        const Box cell = join(Box{a, a}, b);
        const Box part = clipped_bounds(sphere, cell);
        Box seen;
        for (int k = 0; k < 4000; ++k) {
            const Vec3 p = sphere.centre + scale * draw.direction();
            if (!contains(cell, p)) continue;
            seen = join(seen, p);
            REQUIRE(contains(part, p));
        }
        empty += part.empty();
        small += !part.empty() && (part.size() != cell.size());
        if (part.empty()) continue;
        CHECK(contains(cell, part.low));
        CHECK(contains(cell, part.high));
    }
    CHECK(empty > 20);
    CHECK(small > 50);
}

TEST_CASE("clipped bounds of a sphere by hand", "[shape]") {
    const Sphere sphere{Vec3(0), 1};
    CHECK(clipped_bounds(sphere, Box{Vec3(-0.5), Vec3(0.5)}).empty());
    CHECK(clipped_bounds(sphere, Box{Vec3(0.6), Vec3(2)}).empty());
    CHECK(clipped_bounds(sphere, Box{}).empty());
    const Box whole = clipped_bounds(sphere, Box{Vec3(-9), Vec3(9)});
    CHECK(length(whole.low + Vec3(1)) < 1e-14);
    CHECK(length(whole.high - Vec3(1)) < 1e-14);
    const Box cap = clipped_bounds(sphere, Box{Vec3(-2, 0.8, -2), Vec3(2, 2, 2)});
    CHECK(length(cap.low - Vec3(-0.6, 0.8, -0.6)) < 1e-14);
    CHECK(length(cap.high - Vec3(0.6, 1, 0.6)) < 1e-14);
    const Box shell = clipped_bounds(sphere, Box{Vec3(0, -0.1, -0.1), Vec3(2, 0.1, 0.1)});
    CHECK(shell.low.x == Approx(std::sqrt(0.98)).epsilon(1e-14));
}
