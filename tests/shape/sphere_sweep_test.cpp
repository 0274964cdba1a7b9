// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sphere_sweep.h"

#include "shape/sphere.h"
#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::vector<Ball> four = {{-x, 0.3}, {o, 0.3}, {Vec3(1, 1, 0), 0.5}, {2.0 * x, 0.3}};

void check_first(const SphereSweep& sweep, const Vec3& from, const Vec3& at, const Vec3& normal) {
    const auto found = hits(build(sweep), {from, z});
    REQUIRE_FALSE(found.empty());
    CHECK(length(from + found[0].t * z - at) < 1e-4);
    CHECK(length(found[0].normal - normal) < 1e-4);
}

}  // namespace

TEST_CASE("sphere sweeps are met where POV-Ray meets them", "[shape]") {
    const SphereSweep linear{linear_way, {{o, 1}, {4.0 * x, 0.5}}};
    check_first(linear, Vec3(2, 0, -5), Vec3(2, 0, -0.7559), Vec3(0.125, 0, -0.9922));
    CHECK(hits(build(linear), {-5.0 * x, x})[0].t == Approx(4));
    CHECK(inside(build(linear), Vec3(2, 0.7, 0)));
    CHECK_FALSE(inside(build(linear), Vec3(2, 0.8, 0)));
    CHECK(length(bounds(build(linear)).high - Vec3(4.5, 1, 1)) < 1e-14);

    const SphereSweep cubic{cubic_way, four};
    check_first(cubic, Vec3(0.5, 0.5, -5), Vec3(0.5, 0.5, -0.4081),
                Vec3(-0.0235, -0.1828, -0.9829));
    check_first(cubic, Vec3(0, 0, -5), Vec3(0, 0, -0.3014), Vec3(-0.0908, -0.0503, -0.9946));
    const SphereSweep b{b_way, four};
    check_first(b, Vec3(0.5, 0.5, -5), Vec3(0.5, 0.5, -0.3988), Vec3(-0.1105, -0.0158, -0.9938));
}

TEST_CASE("a sweep is the union of its spheres", "[shape]") {
    Draw draw(1);
    std::vector<Ball> balls;
    for (int i = 0; i < 8; ++i) balls.push_back({draw.point(2), draw.between(0.05, 0.8)});
    for (const int spline : {linear_way, cubic_way, b_way}) {
        const BuiltSphereSweep sweep = build({spline, balls});
        const auto within = [&](const Vec3& p) {
            for (const auto& piece : sweep.pieces)
                for (int i = 0; i <= 400; ++i) {
                    const double u = i / 400.0;
                    if (length(p - piece.centre(u)) < std::abs(piece.radius(u))) return true;
                }
            return false;
        };
        for (int i = 0; i < 60; ++i) {
            const Vec3 p = draw.point(2.5);
            if (within(p)) CHECK(inside(sweep, p));
            const Ray ray{draw.point(2.5), draw.direction()};
            const auto found = hits(sweep, ray);
            for (std::size_t k = 0; k + 1 < found.size(); k += 2) {
                CHECK(inside(sweep, ray.at(0.5 * (found[k].t + found[k + 1].t))));
                if (k > 0) CHECK_FALSE(within(ray.at(0.5 * (found[k].t + found[k - 1].t))));
            }
            // There is nothing outside of the found stretches.
            for (double t = -6; t < 6; t += 0.05) {
                const auto before = std::count_if(found.begin(), found.end(),
                                                  [&](const Crossing& c) { return c.t < t; });
                if (within(ray.at(t))) CHECK(before % 2 == 1);
            }
        }
    }
}

TEST_CASE("a sweep of one place is a sphere", "[shape]") {
    const BuiltSphereSweep still = build(SphereSweep{linear_way, {{x, 1}, {x, 1}}});
    CHECK(answers(still, {{-5.0 * x, x}, {{5, -x, true}, {7, x, false}}}));
}

TEST_CASE("what can be wrong with a sphere sweep is said", "[shape]") {
    CHECK(problem(SphereSweep{b_way, four}).empty());
    CHECK(
        problem(SphereSweep{no_way, four}) ==
        "a `sphere_sweep` needs `linear_spline`, `cubic_spline` or `b_spline` before its spheres");
    CHECK(problem(SphereSweep{linear_way, {{o, 1}}}) ==
          "a `sphere_sweep` with this spline needs at least 2 spheres");
    CHECK(vanishes(SphereSweep{linear_way, {{o, 0}, {x, 0}}}) == "all its radii are 0");
    CHECK(vanishes(SphereSweep{linear_way, {{o, 0}, {x, 1}}}).empty());
}

}  // namespace candelabra
