// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_powers.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Two lamps over two points: each gives 10 to its own and 2 to the other, and 1 comes from
/// elsewhere. The second half sees a tenth more of the first lamp.
PowerProblem two_lamps(double low, double high) {
    PowerProblem problem;
    problem.lamps = 2;
    problem.costs = {1, 1};
    problem.halves[0] = {{1, 1}, {10, 2, 2, 10}};
    problem.halves[1] = {{1, 1}, {11, 2, 2.2, 10}};
    problem.demands = {{0, 2, low, high}};
    return problem;
}

}  // namespace

TEST_CASE("the gap between the halves is in terms of the bounds") {
    PowerProblem problem = two_lamps(25, 100);
    problem.demands = {{0, 1, 25, LinearProgramme::unbounded}, {1, 1, 0, 1000}};
    Diagnostics diagnostics;
    const SolvedPowers found = solved(problem, diagnostics);
    // The first lamp alone has to be 2.4: the second point reads 5.8 and 6.28, far below its bound.
    REQUIRE(found.powers.size() == 2);
    CHECK(found.powers[0] == Approx(2.4));
    CHECK(found.gap == Approx(2.4 / 25));
}

TEST_CASE("powers are the least that meet all bounds, and the other half judges them") {
    Diagnostics diagnostics;
    const SolvedPowers found = solved(two_lamps(25, 100), diagnostics);
    CHECK_FALSE(diagnostics.failed());
    REQUIRE(found.powers.size() == 2);
    CHECK(found.powers[0] == Approx(2));  // 10 p + 2 p + 1 = 25
    CHECK(found.powers[1] == Approx(2));
    CHECK(found.cost == Approx(2));
    CHECK(found.met);
    CHECK(found.gap == Approx(2.0 / 25));
    REQUIRE(found.bounds.size() == 4);
    for (const SolvedBound& bound : found.bounds) {
        CHECK(bound.solved == Approx(25));
        CHECK(bound.tight == !bound.upper);
        CHECK_FALSE(bound.missed);
    }
    CHECK(found.bounds[0].judged == Approx(27));
}

TEST_CASE("a lamp whose light may be luck is left out, however cheap it is") {
    PowerProblem problem = two_lamps(25, 100);
    problem.lamps = 3;
    problem.costs = {1, 1, 0.001};
    problem.halves[0].by_lamp = {10, 2, 0.01, 2, 10, 0};
    problem.halves[1].by_lamp = {11, 2, 0.002, 2.2, 10, 0};
    Diagnostics diagnostics;
    const SolvedPowers found = solved(problem, diagnostics);
    REQUIRE(found.powers.size() == 3);
    CHECK(found.unknown == std::vector<std::size_t>{2});
    CHECK(found.powers[0] == Approx(2));
    CHECK(found.powers[2] == 0);
    CHECK(found.met);
    // Twice as near to each other, the halves agree that there is light.
    problem.halves[1].by_lamp[2] = 0.005;
    problem.demands[0].high = LinearProgramme::unbounded;
    CHECK(solved(problem, diagnostics).unknown.empty());
    // A lamp that gives nothing at all is known.
    problem.halves[0].by_lamp[2] = problem.halves[1].by_lamp[2] = 0;
    CHECK(solved(problem, diagnostics).unknown.empty());
}

TEST_CASE("the mean of points is bounded without its points") {
    PowerProblem problem = two_lamps(25, LinearProgramme::unbounded);
    problem.demands[0].of_mean = true;
    problem.costs = {1, 3};
    Diagnostics diagnostics;
    const SolvedPowers found = solved(problem, diagnostics);
    REQUIRE(found.powers.size() == 2);
    CHECK(found.powers[0] == Approx(4));  // the cheaper lamp alone: 6 p + 1 = 25
    CHECK(found.powers[1] == 0);
    REQUIRE(found.bounds.size() == 1);
    CHECK(found.bounds[0].tight);
}

TEST_CASE("bounds that no powers meet are missed by as little as possible") {
    PowerProblem problem = two_lamps(25, 100);
    problem.most = 1;
    problem.demands = {{0, 1, 25, 100}, {1, 1, 5, 100}};
    Diagnostics diagnostics;
    const SolvedPowers found = solved(problem, diagnostics);
    CHECK_FALSE(diagnostics.failed());
    CHECK_FALSE(found.met);
    REQUIRE(found.powers.size() == 2);
    CHECK(found.powers[0] == Approx(1));
    CHECK(found.powers[1] == Approx(1));
    REQUIRE(found.bounds.size() == 4);
    CHECK(found.bounds[0].missed);
    CHECK(found.bounds[0].solved == Approx(13));
    for (std::size_t i = 1; i < 4; ++i) CHECK_FALSE(found.bounds[i].missed);
}

TEST_CASE("light that is there without lamps may be too much") {
    Diagnostics diagnostics;
    const SolvedPowers found = solved(two_lamps(0, 0.5), diagnostics);
    CHECK_FALSE(found.met);
    CHECK(found.powers == std::vector<double>{0, 0});
    REQUIRE(found.bounds.size() == 2);
    CHECK((found.bounds[0].missed && found.bounds[1].missed));
}

TEST_CASE("light that is not finite has no powers") {
    PowerProblem problem = two_lamps(1, 2);
    problem.halves[1].by_lamp[0] = LinearProgramme::unbounded;
    Diagnostics diagnostics;
    CHECK(solved(problem, diagnostics).powers.empty());
    CHECK(diagnostics.failed());
}

}  // namespace candelabra
