// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/lathe.h"

#include "shape/cone.h"
#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::vector<Vec2> lathe_points = {{0.5, -1}, {1, 0}, {0.5, 1}, {1, 2}, {0.2, 3}};

void check_first(const Lathe& lathe, double height, double at, const Vec3& normal) {
    const auto found = hits(build(lathe), {Vec3(-5, height, 0), x});
    REQUIRE(found.size() == 2);
    CHECK(found[0].t == Approx(5 + at).margin(1e-4));
    CHECK(length(found[0].normal - normal) < 1e-4);
    CHECK(found[1].t == Approx(5 - at).margin(1e-4));
}

}  // namespace

TEST_CASE("lathes are met where POV-Ray meets them", "[shape]") {
    const Lathe top{linear_curve, {{0, 0}, {1, 1}, {0, 2}}};
    check_first(top, 0.5, -0.5, Vec3(-0.7071, -0.7071, 0));
    CHECK(bounds(build(top)).high == Vec3(1, 2, 1));
    const Lathe quadratic{quadratic_curve, {lathe_points.begin(), lathe_points.begin() + 4}};
    check_first(quadratic, 0.5, -0.875, Vec3(-0.8944, 0.4472, 0));
    check_first(quadratic, 1.5, -0.625, Vec3(-0.8944, -0.4472, 0));
    CHECK(hits(build(quadratic), {Vec3(-5, -0.5, 0), x}).empty());
    const Lathe cubic{cubic_curve, lathe_points};
    check_first(cubic, 0.5, -0.75, Vec3(-0.8, 0.6, 0));
    check_first(cubic, 1.5, -0.7687, Vec3(-0.7856, -0.6187, 0));
    CHECK(bounds(build(cubic)).high.x == Approx(1.0032).margin(1e-4));
    const Lathe bezier{bezier_curve, {{1, 0}, {2, 0.5}, {0.5, 1}, {1, 2}}};
    check_first(bezier, 0.5, -1.3385, Vec3(-0.9677, 0.2522, 0));
    check_first(bezier, 1.5, -0.8987, Vec3(-0.9955, 0.0949, 0));
}

TEST_CASE("a lathe of straight lines is a pair of cones, for rays of any rise", "[shape]") {
    const BuiltLathe top = build(Lathe{linear_curve, {{0, 0}, {1, 1}, {0, 2}}});
    const Cone lower{Vec3(0), 0, y, 1, true}, upper{y, 1, 2.0 * y, 0, true};
    Draw draw(4);
    for (int i = 0; i < 2000; ++i) {
        const double scale = std::pow(10, draw.between(-12, 0));
        Vec3 direction = draw.direction();
        direction.y *= i % 2 == 0 ? scale : 1;
        const Vec3 target(0.9 * draw.point().x, draw.between(0.05, 1.95), 0.3 * draw.point().z);
        const Ray ray{target - 7.0 * direction, direction};
        auto expected = hits(lower, ray);
        for (const Crossing& c : hits(upper, ray)) expected.push_back(c);
        std::sort(expected.begin(), expected.end(),
                  [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
        const auto found = hits(top, ray);
        REQUIRE(found.size() == expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            CHECK(found[k].t == Approx(expected[k].t).epsilon(1e-9));
            CHECK(length(found[k].normal - expected[k].normal) < 1e-6);
        }
    }
}

TEST_CASE("smooth lathes are met on their surface, for rays of any rise", "[shape]") {
    const Lathe vase{cubic_curve, {{0, -1}, {1, 0}, {0.3, 1}, {1.5, 2}, {0.8, 3}, {0, 4}}};
    const BuiltLathe built = build(vase);
    Draw draw(5);
    for (int i = 0; i < 2000; ++i) {
        Vec3 direction = draw.direction();
        direction.y *= std::pow(10, draw.between(-10, 0));
        const Vec3 target = Vec3(0.5, 1.4, 0.5) * draw.point() + Vec3(0, 1.5, 0);
        const Ray ray{target - 5.0 * direction, direction};
        for (const Crossing& c : hits(built, ray)) {
            const Vec3 p = ray.at(c.t);
            const double radius = std::hypot(p.x, p.z);
            double nearest = 1;
            for (const auto& part : built.parts)
                for (const double u : sign_changes(part.piece.combined({0, 1}, -p.y), {0, 1}))
                    nearest = std::fmin(nearest, std::abs(part.piece.at(u).x - radius));
            // Where the curve is nearly level, its radius is less precise.
            CHECK(nearest * std::hypot(c.normal.x, c.normal.z) < 1e-9);
        }
    }
}

TEST_CASE("the inside of a lathe is between curve and axis", "[shape]") {
    const BuiltLathe top = build(Lathe{linear_curve, {{0, 0}, {1, 1}, {0, 2}}});
    CHECK(inside(top, Vec3(0.5, 0.9, 0)));
    CHECK(inside(top, Vec3(0.5, 1, 0)));
    CHECK_FALSE(inside(top, Vec3(1.1, 1, 0)));
    const BuiltLathe ring = build(Lathe{linear_curve, {{1, 0}, {2, 1}, {3, 0}}});
    CHECK_FALSE(inside(ring, Vec3(1, 0.5, 0)));
    CHECK(inside(ring, Vec3(2, 0.5, 0)));
    CHECK_FALSE(inside(ring, Vec3(2.6, 0.5, 0)));
    // Normals point outward on both sides.
    const auto found = hits(ring, {Vec3(0, 0.5, 0), x});
    REQUIRE(found.size() == 4);
    CHECK(length(found[2].normal - unit(Vec3(-1, 1, 0))) < 1e-12);
    CHECK(length(found[3].normal - unit(Vec3(1, 1, 0))) < 1e-12);
}

TEST_CASE("what can be wrong with a lathe is said", "[shape]") {
    CHECK(problem(Lathe{linear_curve, lathe_points}).empty());
    CHECK(problem(Lathe{}) == "a `lathe` with this spline needs at least 2 points");
    CHECK(problem(Lathe{cubic_curve, {lathe_points.begin(), lathe_points.begin() + 3}}) ==
          "a `lathe` with this spline needs at least 4 points");
    CHECK(problem(Lathe{bezier_curve, lathe_points}) ==
          "a `lathe` with `bezier_spline` needs four points for each piece");
    CHECK(problem(Lathe{linear_curve, {{-1, 0}, {1, 1}}}).empty());
    CHECK(problem(Lathe{linear_curve, {{1, 0}, {-1, 1}, {1, 2}}}) ==
          "a `lathe` needs radii that are not below 0 between its first and its last point");
}

TEST_CASE("a lathe that begins beyond the axis is seen in a mirror there", "[shape]") {
    const Lathe beyond{linear_curve, {{-1, 0}, {2, 3}}};
    check_first(beyond, 0.25, -0.75, unit(Vec3(-1, 1, 0)));
    check_first(beyond, 2, -1, unit(Vec3(-1, -1, 0)));
    CHECK(inside(build(beyond), Vec3(0.7, 0.25, 0)));
    CHECK_FALSE(inside(build(beyond), Vec3(0.8, 0.25, 0)));
}

}  // namespace candelabra
