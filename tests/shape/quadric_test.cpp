// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadric.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {}  // namespace

TEST_CASE("the factors of a quadric belong to the terms that they say", "[shape]") {
    const Quadric ellipsoid{Vec3(1, 2, 3), o, o, -6};
    CHECK(inside(ellipsoid, Vec3(2.4, 0, 0)));
    CHECK(inside(ellipsoid, Vec3(0, 1.7, 0)));
    CHECK_FALSE(inside(ellipsoid, Vec3(0, 1.74, 0)));
    CHECK(inside(ellipsoid, Vec3(0, 0, 1.41)));
    CHECK_FALSE(inside(ellipsoid, Vec3(0, 0, 1.42)));
    CHECK(inside(Quadric{o, x, o, -1}, Vec3(0.9, 1, 9)));
    CHECK_FALSE(inside(Quadric{o, x, o, -1}, Vec3(1.1, 1, 0)));
    CHECK_FALSE(inside(Quadric{o, y, o, -1}, Vec3(1.1, 0, 1)));
    CHECK_FALSE(inside(Quadric{o, z, o, -1}, Vec3(0, 1.1, 1)));
    CHECK(inside(Quadric{o, o, Vec3(1, 2, 3), -1}, Vec3(0.9, 0, 0)));
    CHECK_FALSE(inside(Quadric{o, o, Vec3(1, 2, 3), -1}, Vec3(0, 0, 0.4)));
}

TEST_CASE("rays cross quadrics where they should", "[shape]") {
    const Quadric hyperboloid{Vec3(1, -1, 1), o, o, -1};
    CHECK(answers(hyperboloid, {{-5.0 * z, z}, {{4, -z, true}, {6, z, false}}}));
    CHECK(answers(hyperboloid, {{-5.0 * y, y}, {}}));
    // Past both sheets of a cone: outside between them.
    const Quadric cone{Vec3(1, -1, 1), o, o, 0};
    const Vec3 up = unit(Vec3(1, -1, 0)), down = unit(Vec3(1, 1, 0));
    CHECK(answers(cone, {{Vec3(1, -5, 0), y}, {{4, down, false}, {6, up, true}}}));
    CHECK(answers(Quadric{o, o, 2.0 * y, -6}, {{10.0 * y, -2.0 * y}, {{3.5, y, true}}}));
    const Quadric paraboloid{Vec3(1, 0, 1), o, -y, 0};
    CHECK(answers(paraboloid, {{Vec3(0, -5, 0), y}, {{5, -y, true}}}));
    CHECK(answers(paraboloid, {{Vec3(0, -1, 0), x}, {}}));
    CHECK(answers(Quadric{Vec3(-1), o, o, 1}, {{-5.0 * z, z}, {{4, z, false}, {6, -z, true}}}));
}

TEST_CASE("bounds of a quadric are those of an ellipsoid, or of an elliptic cylinder's section",
          "[shape]") {
    const Box box = bounds(Quadric{Vec3(1, 2, 3), o, o, -6});
    CHECK(length(box.high - Vec3(std::sqrt(6), std::sqrt(3), std::sqrt(2))) < 1e-14);
    CHECK(box.low == -box.high);
    // x^2 + xy + y^2 + z^2 - 2x = 0.
    const Quadric turned{Vec3(1), x, -2.0 * x, 0};
    const Box around = bounds(turned);
    // The minimum in the plane of each side is 0: the side touches the solid.
    for (int axis = 0; axis < 3; ++axis)
        for (const double end : {around.low[axis], around.high[axis]}) {
            double least = 1e9;
            for (double a = -3; a < 3; a += 0.01)
                for (double b = -3; b < 3; b += 0.01) {
                    Vec3 p;
                    p[axis] = end, p[(axis + 1) % 3] = a, p[(axis + 2) % 3] = b;
                    const double v = p.x * p.x + p.x * p.y + p.y * p.y + p.z * p.z - 2 * p.x;
                    least = std::fmin(least, v);
                }
            CHECK(std::abs(least) < 1e-3);
        }
    const Box tube = bounds(Quadric{Vec3(4, 0, 1), o, o, -1});
    CHECK(tube.high.x == 0.5);
    CHECK(tube.high.z == 1);
    CHECK(tube.low.y == -std::numeric_limits<double>::infinity());
    CHECK_FALSE(finite(bounds(Quadric{Vec3(1, -1, 1), o, o, -1})));
    CHECK_FALSE(finite(bounds(Quadric{Vec3(-1), o, o, 1})));
    CHECK(bounds(Quadric{Vec3(1), o, o, 1}).empty());
}

TEST_CASE("a quadric needs a factor besides its constant", "[shape]") {
    CHECK(vanishes(Quadric{}).empty());
    CHECK(vanishes(Quadric{o, o, o, -1}) == "all its factors besides the constant are 0");
}

TEST_CASE("between planes, a quadric has bounds", "[shape]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Box layer{Vec3(-infinity, -1, -infinity), Vec3(infinity, 2, infinity)};
    const Box waist = bounds_within({Vec3(1, -1, 1), o, o, -1}, layer);
    CHECK(waist.high.x == Approx(std::sqrt(5)));
    CHECK(waist.low.z == Approx(-std::sqrt(5)));
    CHECK(waist.low.y == -1);
    const Box bowl = bounds_within({Vec3(1, 0, 1), o, -y, 0}, layer);
    CHECK(bowl.low.y == Approx(0).margin(1e-8));
    CHECK(bowl.high.x == Approx(std::sqrt(2)));
    // Nothing is known of a cylinder along the layer.
    CHECK(bounds_within({Vec3(0, 1, 1), o, o, -1}, layer).high.x == infinity);
}

TEST_CASE("no point of a quadric in a box is outside of its bounds there", "[shape]") {
    Draw draw(8);
    int points = 0;
    for (int i = 0; i < 300; ++i) {
        const Quadric q{draw.point(1), i % 2 == 0 ? o : draw.point(1), draw.point(1),
                        draw.between(-1, 1)};
        const Vec3 corner = draw.point(2);
        const Box box{corner, corner + Vec3(draw.between(0.1, 2), draw.between(0.1, 2), 3)};
        const Box part = bounds_within(q, box);
        for (int k = 0; k < 200; ++k) {
            const Vec3 p = box.low + Vec3(draw.number(), draw.number(), draw.number()) * box.size();
            if (!inside(q, p)) continue;
            ++points;
            REQUIRE(contains(part, p));
        }
    }
    CHECK(points > 1000);
}

}  // namespace candelabra
