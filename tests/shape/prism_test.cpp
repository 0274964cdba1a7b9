// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/prism.h"

#include "support/axes.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Prism prism(int spline, double low, double high, const std::vector<Vec2>& points) {
    return {linear_sweep, spline, low, high, points, false};
}

const std::vector<Vec2> ring = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
const std::vector<Vec2> square = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};

Crossing first_hit(const Prism& prism, const Ray& ray) { return hits(build(prism), ray).at(0); }

}  // namespace

TEST_CASE("a prism is its outline between two heights", "[shape]") {
    const BuiltPrism wedge = build(prism(linear_curve, 1, 0, {{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
    CHECK(inside(wedge, Vec3(0.7, 0.5, 0.3)));
    CHECK_FALSE(inside(wedge, Vec3(0.3, 0.5, 0.7)));
    CHECK(inside(wedge, Vec3(0.7, 0, 0.3)));
    CHECK_FALSE(inside(wedge, Vec3(0.7, 1, 0.3)));
    CHECK(bounds(wedge).low == o);
    CHECK(bounds(wedge).high == Vec3(1));
    CHECK(answers(wedge, {{Vec3(0.7, 5, 0.3), -y}, {{4, y, true}, {5, -y, false}}}));
    CHECK(answers(wedge, {{Vec3(5, 0.5, 0.3), -2.0 * x},
                          {{2, x, true}, {2.35, unit(Vec3(-1, 0, 1)), false}}}));
    CHECK(answers(wedge, {{Vec3(5, 1.5, 0.3), -x}, {}}));
}

TEST_CASE("curved prisms are met where POV-Ray meets them", "[shape]") {
    const Prism quadratic = prism(quadratic_curve, 0, 1, {ring.begin(), ring.begin() + 6});
    const Crossing a = first_hit(quadratic, {Vec3(-5, 0.5, 0.2), x});
    CHECK(a.t == Approx(5 - 0.8944).margin(1e-4));
    CHECK(length(a.normal - Vec3(-0.8729, 0, 0.488)) < 1e-4);
    const Crossing b = first_hit(prism(cubic_curve, 0, 1, ring), {Vec3(-5, 0.5, 0.2), x});
    CHECK(b.t == Approx(5 - 0.9442).margin(1e-4));
    CHECK(length(b.normal - Vec3(-0.9005, 0, 0.4349)) < 1e-4);
    const BuiltPrism lens =
        build(prism(bezier_curve, 0, 1,
                    {{1, 0}, {1, 1}, {-1, 1}, {-1, 0}, {-1, 0}, {-1, -1}, {1, -1}, {1, 0}}));
    CHECK(inside(lens, Vec3(0, 0.5, 0.7)));
    CHECK_FALSE(inside(lens, Vec3(0, 0.5, 0.8)));
}

TEST_CASE("a conic sweep grows from the origin", "[shape]") {
    const BuiltPrism pyramid = build({conic_sweep, linear_curve, 0, 2, square, false});
    CHECK(inside(pyramid, Vec3(0.5, 0.6, 0.5)));
    CHECK_FALSE(inside(pyramid, Vec3(0.5, 0.4, 0.5)));
    CHECK(inside(pyramid, Vec3(1.9, 1.95, 1.9)));
    CHECK(bounds(pyramid).low == Vec3(-2, 0, -2));
    CHECK(bounds(pyramid).high == Vec3(2));
    const Vec3 left = unit(Vec3(-1, -1, 0));
    CHECK(answers(pyramid,
                  {{Vec3(-5, 1, 0.1), x}, {{4, left, true}, {6, unit(Vec3(1, -1, 0)), false}}}));
    CHECK(answers(pyramid, {{Vec3(-0.5, -3, 0.1), y}, {{3.5, left, true}, {5, y, false}}}));
    const BuiltPrism hourglass = build({conic_sweep, linear_curve, -1, 1, square, true});
    CHECK(inside(hourglass, Vec3(0.3, -0.5, 0.3)));
    CHECK(answers(hourglass,
                  {{Vec3(-5, -0.5, 0.1), x},
                   {{4.5, unit(Vec3(-1, 1, 0)), true}, {5.5, unit(Vec3(1, 1, 0)), false}}}));
}

TEST_CASE("an open prism has no ends, and holes are walls", "[shape]") {
    Prism tube =
        prism(linear_curve, 0, 1,
              {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}});
    CHECK(answers(build(tube), {{Vec3(-1, 0.5, 2), x},
                                {{1, -x, true}, {2, x, false}, {4, -x, true}, {5, x, false}}}));
    CHECK(hits(build(tube), {Vec3(0.5, 5, 0.5), -y}).size() == 2);
    CHECK(hits(build(tube), {Vec3(2, 5, 2), -y}).empty());
    tube.open = true;
    CHECK(hits(build(tube), {Vec3(0.5, 5, 0.5), -y}).empty());
}

TEST_CASE("what can be wrong with a prism is said", "[shape]") {
    CHECK(problem(prism(linear_curve, 0, 1, square)).empty());
    CHECK(problem(prism(linear_curve, 0, 1, {{0, 0}, {1, 0}})) ==
          "a `prism` with this spline needs at least 3 points");
    CHECK(problem(prism(bezier_curve, 0, 1, ring)) ==
          "a `prism` with `bezier_spline` needs four points for each piece");
    CHECK(problem(prism(cubic_curve, 0, 1, {ring.begin(), ring.begin() + 6})) ==
          "a loop of this `prism` does not come back to its start");
}

TEST_CASE("a prism without a height is entered and left at once", "[shape]") {
    const BuiltPrism sheet = build(prism(linear_curve, 1, 1, square));
    CHECK(answers(sheet, {{5.0 * y, -y}, {{4, y, true}, {4, -y, false}}}));
    CHECK(answers(sheet, {{-5.0 * y, y}, {{6, -y, true}, {6, y, false}}}));
    CHECK_FALSE(inside(sheet, y));
}

}  // namespace candelabra
