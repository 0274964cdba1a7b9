// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/parametric.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Handle<Formula> function(double (*code)(double, double)) {
    return make_handle<Formula>(3, 1, [code](const double* p, double* value) {
        *value = code(p[0], p[1]);
        return true;
    });
}

}  // namespace

TEST_CASE("rays meet a parametric surface itself, not its facets", "[shape]") {
    Parametric bowl;
    CHECK(problem(bowl) == "a `parametric` needs three functions");
    bowl.x = function([](double u, double) { return u; });
    bowl.y = function([](double u, double v) { return u * u + v * v; });
    bowl.z = function([](double, double v) { return v; });
    CHECK(problem(bowl).empty());
    bowl.first = bowl.last = Vec2(-1);
    CHECK(vanishes(bowl) == "its range of u is empty");
    bowl.last.x = 1;
    CHECK(vanishes(bowl) == "its range of v is empty");
    bowl.last.y = 1;
    CHECK(vanishes(bowl).empty());
    const BuiltParametric built = build(bowl);
    const auto found = hits(built, {Vec3(0.123, 5, 0.321), Vec3(0, -1, 0)});
    REQUIRE(found.size() == 1);
    CHECK(found[0].t == Approx(5 - 0.123 * 0.123 - 0.321 * 0.321).epsilon(1e-12));
    // u and v are recovered with the cell of the net or without it.
    const Vec3 met(0.123, 0.123 * 0.123 + 0.321 * 0.321, 0.321);
    CHECK(length(parameters_at(built, met, found[0].part) - Vec2(0.123, 0.321)) < 1e-9);
    CHECK(length(parameters_at(built, met, std::nullopt) - Vec2(0.123, 0.321)) < 1e-9);
    // Cut off by the container, which extends from -1 to 1.
    CHECK(hits(built, {Vec3(0.9, 5, 0.9), Vec3(0, -1, 0)}).empty());
}

TEST_CASE("a parametric surface with a pole has no facets across it", "[shape]") {
    Parametric wall;
    wall.x = function([](double u, double) { return u; });
    wall.y = function([](double u, double) { return std::tan(3 * u); });
    wall.z = function([](double, double v) { return v; });
    wall.first = Vec2(-0.99);
    wall.last = Vec2(1);
    const BuiltParametric built = build(wall);
    const double pole = 0.523598775598;
    CHECK(hits(built, {Vec3(pole, 5, 0.1), Vec3(0, -1, 0)}).empty());
    // Two branches of the tangent with nothing between them.
    CHECK(hits(built, {Vec3(0.5, 0.95, 0.1), Vec3(1, 0, 0)}).size() == 2);
    for (const ParametricPiece& piece : built.pieces)
        CHECK(length(piece.corners[2] - piece.corners[0]) < 4);
    const auto found = hits(built, {Vec3(-0.2, 5, 0.1), Vec3(0, -1, 0)});
    REQUIRE(found.size() == 1);
    CHECK(found[0].t == Approx(5 - std::tan(-0.6)));
}

}  // namespace candelabra
