// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/cylinder.h"

#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rays cross a cylinder where they should", "[shape]") {
    const Cylinder solid{Vec3(0, -1, 0), Vec3(0, 1, 0), 1, false};
    const Cylinder tube{Vec3(0, -1, 0), Vec3(0, 1, 0), 1, true};
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    struct Row {
        Ray ray;
        std::vector<ExpectedHit> solid, tube;
    };
    const std::vector<Row> table = {
        {{Vec3(0, 5, 0.1), -y}, {{4, y, true}, {6, -y, false}}, {}},
        {{Vec3(0, 0, -5), z}, {{4, -z, true}, {6, z, false}}, {{4, -z, true}, {6, z, false}}},
        {{Vec3(0, 5, 0), Vec3(0, -1, 0.2)}, {{4, y, true}, {5, z, false}}, {{5, z, false}}},
        {{Vec3(-3, 0, 0), 100.0 * x},
         {{0.02, -x, true}, {0.04, x, false}},
         {{0.02, -x, true}, {0.04, x, false}}},
        {{Vec3(0, 5, 1.5), -y}, {}, {}},
        {{Vec3(-3, 0, 1), x}, {}, {}},
        {{Vec3(-3, 1.5, 0), x}, {}, {}},
        {{Vec3(-3, 3, 0), Vec3(1, -0.5, 0)}, {}, {}},
        {{Vec3(0), Vec3(0)}, {}, {}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(solid, {table[i].ray, table[i].solid}));
        CHECK(answers(tube, {table[i].ray, table[i].tube}));
    }
}

TEST_CASE("the surface of a cylinder belongs to it only when it is open", "[shape]") {
    for (const bool open : {false, true}) {
        const Cylinder cylinder{Vec3(0, -1, 0), Vec3(0, 1, 0), 1, open};
        CHECK(inside(cylinder, Vec3(0, 0.5, 0)));
        CHECK(inside(cylinder, Vec3(1, 0, 0)) == open);
        CHECK(inside(cylinder, Vec3(0, 1, 0)) == open);
        CHECK_FALSE(inside(cylinder, Vec3(0, 1.01, 0)));
        CHECK_FALSE(inside(cylinder, Vec3(1.01, 0, 0)));
    }
}

TEST_CASE("bounds of a cylinder are tight", "[shape]") {
    const Box upright = bounds(Cylinder{Vec3(0, -1, 0), Vec3(0, 1, 0), 1, false});
    CHECK(upright.low == Vec3(-1));
    CHECK(upright.high == Vec3(1));
    const double w = std::sqrt(0.5);
    const Box tilted = bounds(Cylinder{Vec3(1, 1, 0), Vec3(0, 0, 0), 1, false});
    CHECK(length(tilted.low - Vec3(-w, -w, -1)) < 1e-15);
    CHECK(length(tilted.high - Vec3(1 + w, 1 + w, 1)) < 1e-15);
}

TEST_CASE("cylinders of all forms are met on their surface", "[shape]") {
    Draw draw(3);
    for (const double radius : {1e-6, 1e-2, 1.0, 1e4})
        for (const double height : {1e-6, 1.0, 1e6})
            for (const double distance : {1.0, 1e6}) {
                INFO("radius " << radius << " height " << height << " distance " << distance);
                for (int i = 0; i < 40; ++i) {
                    const Vec3 base = draw.point(distance), cap = base + height * draw.direction();
                    const Vec3 up = unit(cap - base);
                    const Cylinder cylinder{base, cap, radius, false};
                    const Vec3 aside = unit(cross(up, draw.direction()));
                    const Vec3 target = base + draw.between(0.1, 0.9) * height * up +
                                        draw.between(0, 0.9) * radius * aside;
                    const Vec3 origin = target + (radius + height + distance) * draw.direction();
                    const Ray ray{origin, std::exp(draw.between(-9, 9)) * (target - origin)};
                    const double size = radius + height + distance, tolerance = 1e-14 * size;
                    if (std::fmin(radius, height) < 1e3 * tolerance) continue;
                    const std::vector<Crossing> found = hits(cylinder, ray);
                    REQUIRE(found.size() == 2);
                    for (const Crossing& c : found) {
                        const Vec3 p = ray.at(c.t) - base;
                        const double along = dot(p, up), off = length(p - along * up);
                        const double from_side = std::abs(off - radius);
                        const double from_end =
                            std::fmin(std::abs(along), std::abs(dot(ray.at(c.t) - cap, up)));
                        const bool at_end = std::abs(dot(c.normal, up)) > 0.5;
                        CHECK((at_end ? from_end : from_side) <= 10 * tolerance);
                    }
                }
            }
}

TEST_CASE("a cylinder needs two ends", "[shape]") {
    CHECK(problem(Cylinder{}) == "");
    CHECK(problem(Cylinder{Vec3(1), Vec3(1), 1, false}) ==
          "a `cylinder` needs two different end points");
}

}  // namespace candelabra
