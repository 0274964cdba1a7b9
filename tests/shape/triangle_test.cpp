// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/triangle.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Interval onwards() { return {}; }

}  // namespace

TEST_CASE("rays cross a triangle where they should, and its normal stays on its side", "[shape]") {
    const std::vector<std::pair<Triangle, RayCase>> table = {
        {{o, x, y}, {{Vec3(0.2, 0.3, -5), z}, {{5, -z, true}}}},
        {{o, x, y}, {{Vec3(0.2, 0.3, 5), -z}, {{5, -z, false}}}},
        {{o, y, x}, {{Vec3(0.2, 0.3, -5), 2.0 * z}, {{2.5, z, false}}}},
        {{o, x, y}, {{Vec3(0.2, 0.3, 5), z}, {{-5, -z, true}}}},
        {{o, x, y}, {{Vec3(0.6, 0.6, -5), z}, {}}},
        {{o, x, y}, {{Vec3(-0.1, 0.1, -5), z}, {}}},
        {{o, x, y}, {{Vec3(0.5, 0.5, -5), z}, {{5, -z, true}}}},
        {{o, x, y}, {{Vec3(0, 0, -5), z}, {{5, -z, true}}}},
        {{o, x, y}, {{Vec3(-5, 0.2, 0), x}, {}}},
        {{o, x, y}, {{Vec3(-5, 0.2, -1), Vec3(5.2, 0, 1)}, {{1, -z, true}}}},
        {{o, x, y}, {{Vec3(0.2, 0.3, -5), o}, {}}},
        {{o, x, 2.0 * x}, {{Vec3(0.2, 0, -5), z}, {}}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(table[i].first, table[i].second));
        CHECK_FALSE(inside(table[i].first, Vec3(0.2, 0.3, 0)));
    }
}

TEST_CASE("a smooth triangle blends the unit normals of its corners", "[shape]") {
    const SmoothTriangle blended{o, 3.0 * -z, x, Vec3(1, 0, -1), y, Vec3(0, 1, -1)};
    const Vec3 expected = unit(0.5 * -z + 0.2 * unit(Vec3(1, 0, -1)) + 0.3 * unit(Vec3(0, 1, -1)));
    CHECK(length(expected - Vec3(0.1588, 0.2381, -0.9582)) < 1e-4);
    CHECK(answers(blended, {{Vec3(0.2, 0.3, -5), z}, {{5, expected, true}}}));
    CHECK(answers(blended, {{Vec3(0.2, 0.3, 5), -z}, {{5, expected, false}}}));
    const SmoothTriangle opposed{o, x, x, -x, y, z};
    CHECK(answers(opposed, {{Vec3(0.5, 0, -5), z}, {{5, -z, true}}}));
}

TEST_CASE("weights belong to the corners", "[shape]") {
    const Vec3 a(1, 2, 3), b(4, 1, 2), c(0, 5, 9);
    const Vec3 p = 0.2 * a + 0.3 * b + 0.5 * c;
    for (const Vec3& direction :
         {Vec3(1, 2, 3), Vec3(-5, 1, 0.5), Vec3(0.1, -8, 1), Vec3(1, 1, -9)}) {
        const TriangleHit hit =
            first_crossing(a, b, c, Ray{p - 7.0 * direction, direction}, onwards());
        CHECK(hit.t == Approx(7));
        CHECK(hit.weight2 == Approx(0.3));
        CHECK(hit.weight3 == Approx(0.5));
    }
    CHECK(first_crossing(a, b, c, Ray{p - z, z}, Interval{0, 0.5}).t == 0.5);
    CHECK(first_crossing(a, b, c, Ray{p - z, z}, Interval{1.5, 9}).t == 9);
}

TEST_CASE("fans of triangles leave no gap, and one of them is met when only one may be",
          "[shape]") {
    Draw draw(5);
    for (int i = 0; i < 2000; ++i) {
        const double far = std::pow(10, draw.between(-2, 6));
        const Vec3 up = draw.direction(), hub = draw.point(far);
        const auto [side, other] = perpendiculars(up);
        std::vector<Vec3> rim;
        for (int k = 0; k < 7; ++k) {
            const double angle = 0.8976 * k + draw.between(0, 0.5);
            rim.push_back(hub + std::cos(angle) * side + std::sin(angle) * other +
                          0.1 * draw.point());
        }
        // Through the hub or a point of a spoke, exactly or nearly, as far as numbers allow.
        const Vec3& spoke = rim[static_cast<std::size_t>(i) % 7];
        const Vec3 target = hub + (i % 3 == 0 ? 0 : draw.between(0, 0.3)) * (spoke - hub);
        const Vec3 direction = up + 0.2 * draw.direction();
        const Ray ray{target - std::floor(draw.between(1, 100)) * direction, direction};
        const ShearedRay any(ray), single(ray, Edges::one);
        int met_any = 0, met_single = 0;
        for (std::size_t k = 0; k < 7; ++k) {
            met_any += any.meet(hub, rim[k], rim[(k + 1) % 7], onwards()).t < onwards().max;
            met_single += single.meet(rim[k], rim[(k + 1) % 7], hub, onwards()).t < onwards().max;
        }
        CHECK(met_any >= 1);
        CHECK(met_single == 1);
    }
}

TEST_CASE("a triangle seen edge-on is met within its bounds or not at all", "[shape]") {
    Draw draw(10);
    for (int i = 0; i < 5000; ++i) {
        const Triangle t{draw.point(), draw.point(), draw.point()};
        const Vec3 along = unit(draw.between(-1, 1) * (t.corner2 - t.corner1) +
                                draw.between(-1, 1) * (t.corner3 - t.corner1));
        const Vec3 target = (t.corner1 + t.corner2 + t.corner3) / 3.0;
        const Ray ray{target - draw.between(1, 1e4) * along, along};
        const Box box = bounds(t), around{box.low - Vec3(1e-9), box.high + Vec3(1e-9)};
        for (const Crossing& c : hits(t, ray)) CHECK(contains(around, ray.at(c.t)));
    }
}

TEST_CASE("edges and corners that a ray meets exactly", "[shape]") {
    // A square of two triangles, and a third on the same side of the diagonal as the first.
    for (const Vec3& p : {Vec3(0.5, 0.5, -1), Vec3(0.25, 0.25, -1), Vec3(0.75, 0.75, -1)}) {
        const ShearedRay single(Ray{p, z}, Edges::one);
        const bool first = single.meet(o, x, x + y, onwards()).t == 1,
                   second = single.meet(o, x + y, y, onwards()).t == 1;
        CHECK(first != second);
        const bool folded = single.meet(o, x + y, x + z, onwards()).t < onwards().max;
        CHECK(folded == first);
    }
}

TEST_CASE("clipped bounds of a triangle hold its part in the cell, and little more", "[shape]") {
    Draw draw(6);
    int empty = 0;
    for (int i = 0; i < 2000; ++i) {
        const double scale = std::pow(10, draw.between(-6, 6));
        const Vec3 centre = scale * draw.point(1000);
        const Triangle t{centre + scale * draw.point(), centre + scale * draw.point(),
                         centre + scale * draw.point()};
        const Vec3 a = centre + scale * draw.point(), b = centre + scale * draw.point();
        const Box cell = join(Box{a, a}, b);
        const Box part = clipped_bounds(t, cell);
        Box seen;
        for (int k = 0; k < 200; ++k) {
            const double s = std::sqrt(draw.number()), v = draw.number();
            const Vec3 p = (1 - s) * t.corner1 + s * (1 - v) * t.corner2 + s * v * t.corner3;
            if (!contains(cell, p)) continue;
            seen = join(seen, p);
            REQUIRE(contains(part, p));
        }
        empty += part.empty();
        if (part.empty()) continue;
        CHECK(contains(cell, part.low));
        CHECK(contains(cell, part.high));
    }
    CHECK(empty > 100);
}

TEST_CASE("clipped bounds of a triangle by hand", "[shape]") {
    const Triangle t{o, Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const Box corner = clipped_bounds(t, Box{Vec3(1, 1, -1), Vec3(9, 9, 1)});
    CHECK(length(corner.low - Vec3(1, 1, 0)) < 1e-13);
    CHECK(length(corner.high - Vec3(3, 3, 0)) < 1e-13);
    const Box slice = clipped_bounds(t, Box{Vec3(-1, 1, -1), Vec3(9, 2, 1)});
    CHECK(length(slice.low - Vec3(0, 1, 0)) < 1e-13);
    CHECK(length(slice.high - Vec3(3, 2, 0)) < 1e-13);
    CHECK(clipped_bounds(t, Box{Vec3(2.5, 2.5, -1), Vec3(9, 9, 1)}).empty());
    CHECK(clipped_bounds(t, Box{Vec3(1, 1, 1), Vec3(2, 2, 2)}).empty());
    CHECK(clipped_bounds(t, Box{}).empty());
    CHECK_FALSE(clipped_bounds(t, Box{Vec3(-1, -1, -1), Vec3(9, 9, 0)}).empty());
    CHECK_FALSE(clipped_bounds(t, Box{Vec3(-1, -1, 0), Vec3(9, 9, 1)}).empty());
}

TEST_CASE("a triangle needs an area, a smooth one also normals", "[shape]") {
    const std::string flat = "its corners are on one line";
    CHECK(vanishes(Triangle{}) == "");
    CHECK(vanishes(Triangle{o, x, y}) == "");
    CHECK(vanishes(Triangle{o, 1e-6 * x, 1e6 * y}) == "");
    CHECK(vanishes(Triangle{o, o, y}) == flat);
    CHECK(vanishes(Triangle{Vec3(0.1), Vec3(0.2), Vec3(0.3)}) == flat);
    CHECK(vanishes(Triangle{Vec3(std::nan("")), x, y}) == flat);
    CHECK(vanishes(SmoothTriangle{}) == "");
    CHECK(vanishes(SmoothTriangle{o, z, x, z, 2.0 * x, z}) == flat);
    CHECK(problem(SmoothTriangle{o, o, x, o, 2.0 * x, o}) == "");
    // As in POV-Ray, all normals must be on one side.
    const std::string apart = "its normals are not all on one side of it";
    CHECK(vanishes(SmoothTriangle{o, -z, x, -z, y, -z}) == "");
    CHECK(vanishes(SmoothTriangle{o, z, x, -z, y, z}) == apart);
    CHECK(vanishes(SmoothTriangle{o, z, x, y, y, z}) == apart);
    CHECK(vanishes(SmoothTriangle{o, z, x, o, y, z}) == apart);
    CHECK(problem(SmoothTriangle{o, z, x, 1e200 * z, y, z}) ==
          "a `smooth_triangle` needs normals with lengths below 1e150");
}

}  // namespace candelabra
