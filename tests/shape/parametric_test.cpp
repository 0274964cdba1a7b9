// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/parametric.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

TEST_CASE("rays meet a parametric surface itself, not its facets", "[shape]") {
    const auto function = [](double (*code)(double, double)) {
        return make_handle<Formula>(3, 1, [code](const double* p, double* value) {
            *value = code(p[0], p[1]);
            return true;
        });
    };
    Parametric bowl;
    CHECK(problem(bowl) == "a `parametric` needs three functions");
    bowl.x = function([](double u, double) { return u; });
    bowl.y = function([](double u, double v) { return u * u + v * v; });
    bowl.z = function([](double, double v) { return v; });
    CHECK(problem(bowl) == "a `parametric` needs a range of u and of v");
    bowl.first = Vec2(-1);
    bowl.last = Vec2(1);
    CHECK(problem(bowl).empty());
    const BuiltParametric built = build(bowl);
    const auto found = hits(built, {Vec3(0.123, 5, 0.321), Vec3(0, -1, 0)});
    REQUIRE(found.size() == 1);
    CHECK(found[0].t == Approx(5 - 0.123 * 0.123 - 0.321 * 0.321).epsilon(1e-12));
    // Its u and v are found again, with the mesh of the net or without.
    const Vec3 met(0.123, 0.123 * 0.123 + 0.321 * 0.321, 0.321);
    CHECK(length(parameters_at(built, met, found[0].part) - Vec2(0.123, 0.321)) < 1e-9);
    CHECK(length(parameters_at(built, met, std::nullopt) - Vec2(0.123, 0.321)) < 1e-9);
    // Cut off by the container, which goes from -1 to 1.
    CHECK(hits(built, {Vec3(0.9, 5, 0.9), Vec3(0, -1, 0)}).empty());
}
