// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/polygon.h"

#include "support/axes.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a polygon is met within its edges and not in its holes", "[shape]") {
    const BuiltPolygon square = build(Polygon{{o, x, x + y, y, o}});
    const Vec3 middle(0.5, 0.5, -5);
    CHECK(answers(square, {{middle, z}, {{5, z, false}}}));
    CHECK(answers(square, {{-middle + Vec3(1, 1, 0), -z}, {{5, z, true}}}));
    CHECK(answers(square, {{Vec3(1.5, 0.5, -5), z}, {}}));
    CHECK(answers(square, {{Vec3(-5, 0.5, 0), x}, {}}));
    CHECK_FALSE(inside(square, Vec3(0.5, 0.5, 0)));

    const BuiltPolygon frame =
        build(Polygon{{o, 3.0 * x, Vec3(3, 3, 0), 3.0 * y, o, Vec3(1, 1, 0), Vec3(2, 1, 0),
                       Vec3(2, 2, 0), Vec3(1, 2, 0), Vec3(1, 1, 0)}});
    CHECK(answers(frame, {{middle, z}, {{5, z, false}}}));
    CHECK(answers(frame, {{Vec3(1.5, 1.5, -5), z}, {}}));
    CHECK(bounds(frame).high == Vec3(3, 3, 0));
}

TEST_CASE("a polygon may lie in any plane", "[shape]") {
    const Vec3 a(1, 2, 3), u(1, 1, 0), v(0, 1, 2);
    const BuiltPolygon tilted = build(Polygon{{a, a + u, a + u + v, a + v}});
    const Vec3 normal = unit(cross(u, v));
    CHECK(answers(tilted, {{a + 0.3 * u + 0.9 * v + 2.0 * normal, -normal}, {{2, normal, true}}}));
    CHECK(answers(tilted, {{a + 1.1 * u + 0.9 * v + 2.0 * normal, -normal}, {}}));
}

TEST_CASE("polygons that are rectangles are known as such", "[shape]") {
    const Vec3 a(1, 2, 3), u(2, 0, 1), v(-1, 0, 2), up(0, 3, 0);
    CHECK(build(Polygon{{a, a + u, a + u + v, a + v, a}}).rectangle);
    const auto open = build(Polygon{{a, a + u, a + u + up, a + up}}).rectangle;
    REQUIRE(open);
    CHECK(open->corner == a);
    CHECK(open->side2 == up);
    CHECK_FALSE(build(Polygon{{a, a + u, a + u + x, a + x}}).rectangle);
    CHECK_FALSE(build(Polygon{{a, a + u, a + u + 0.9 * v, a + v}}).rectangle);
    CHECK_FALSE(build(Polygon{{a, a + u, a + u + v, a + v, a, a + u}}).rectangle);
    CHECK_FALSE(build(Polygon{{o, x, y}}).rectangle);
}

TEST_CASE("what can be wrong with a polygon is said", "[shape]") {
    CHECK(problem(Polygon{{o, x, y}}).empty());
    CHECK(problem(Polygon{{o, x}}) == "a `polygon` needs at least 3 corners");
    CHECK(problem(Polygon{{o, x, 2.0 * x, o}}) ==
          "a `polygon` needs three corners that are not on one line");
    CHECK(problem(Polygon{{o, x, x + y + 0.1 * z, y}}) ==
          "the corners of a `polygon` must lie in one plane");
}

}  // namespace candelabra
