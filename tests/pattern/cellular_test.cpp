// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/cellular.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("patterns of cells have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"cells", {0.824241705, 0.030540943, 0.773327578, 0.892267187}},
        {"crackle", {0.154596271, 0.208639105, 0.607077421, 0.001733538}},
        {"crackle solid", {0.432821227, 0.556078485, 0.821148135, 0.498324511}},
        {"crackle form <1,0,0> metric 1", {0.875422354, 0.701406465, 0.404367318, 1.000000000}},
        {"crackle form <0,1,-0.3> metric 3 offset 0.2",
         {0.428426469, 0.314442558, 0.571027523, 0.489734980}},
        {"crackle form <-1,0,1> metric 2 offset 0.5",
         {0.136285486, 0.440899639, 0.481000087, 0.042739194}},
        {"crackle metric 1 offset 0.3 form <1,0,0>",
         {1.000000000, 1.000000000, 0.704367318, 1.000000000}},
    });
}

TEST_CASE("crackle repeats after whole numbers of cells along each axis", "[pattern]") {
    Crackle crackle;
    crackle.repeat = Vec3(2, 3.9, 0);
    const auto at = [&](const Vec3& place) {
        return evaluate(crackle, PatternPoint{place, PatternModifiers(), PatternScene()});
    };
    for (const bool solid : {false, true})
        for (const Vec3& place : {Vec3(0.3, 1.2, -4.1), Vec3(-7.7, 2.9, 0.4)}) {
            crackle.solid = solid;
            CHECK(at(place + Vec3(2, 0, 0)) == Approx(at(place)).epsilon(1e-9));
            CHECK(at(place + Vec3(-6, 3, 0)) == Approx(at(place)).epsilon(1e-9));
            CHECK(at(place + Vec3(0, 0, 2)) != Approx(at(place)));
            CHECK(at(place + Vec3(1, 0, 0)) != Approx(at(place)));
        }
}

TEST_CASE("cells count points just below a border as on it", "[pattern]") {
    CHECK(evaluate(Cells{}, {1 - 1e-12, 0.5, 0.5}) == evaluate(Cells{}, {1.5, 0.5, 0.5}));
    CHECK(evaluate(Cells{}, {1 - 1e-9, 0.5, 0.5}) == evaluate(Cells{}, {0.5, 0.5, 0.5}));
}

TEST_CASE("the nearest nucleus is nearer than the others", "[pattern]") {
    const Vec3 point(0.3, -7.2, 5.5);
    const Vec3 nucleus = nearest_nucleus(point, 2);
    CHECK(length(nucleus - point) < 1);
    CHECK(nearest_nucleus(nucleus, 2) == nucleus);
    CHECK(nearest_nucleus(point, 1) != nucleus);
}

}  // namespace candelabra
