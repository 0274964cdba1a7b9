// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loaded_library.h"
#include "solver/linear_programme.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const Solver& the_solver_of_tests() {
    const LoadedFunction library = load_function(solver_library, solver_function);
    INFO(library.problem);
    REQUIRE(library.address);
    return *reinterpret_cast<const Solver* (*)()>(library.address)();
}

}  // namespace

TEST_CASE("a linear programme is solved as by hand") {
    // Least 2x + 3y where x + y >= 4, x + 3y >= 6: at the corner (3, 1).
    LinearProgramme programme;
    programme.costs = {2, 3};
    programme.most = {LinearProgramme::unbounded, LinearProgramme::unbounded};
    programme.rows = {{{1, 1}, 4}, {{1, 3}, 6}};
    std::vector<double> x;
    CHECK(the_solver_of_tests().minimise(programme, x) == "");
    REQUIRE(x.size() == 2);
    CHECK(x[0] == Approx(3));
    CHECK(x[1] == Approx(1));
    // With x no greater than 2, y makes up for it.
    programme.most[0] = 2;
    CHECK(the_solver_of_tests().minimise(programme, x) == "");
    CHECK(x[0] == Approx(2));
    CHECK(x[1] == Approx(2));
}

TEST_CASE("a linear programme that has no solution says so, and a slack gives it one") {
    LinearProgramme programme;
    programme.costs = {1};
    programme.most = {1};
    programme.rows = {{{1}, 3}};
    std::vector<double> x;
    CHECK(the_solver_of_tests().minimise(programme, x) != "");
    programme.costs = {0, 1};
    programme.most = {1, LinearProgramme::unbounded};
    programme.rows[0].slack = 4;
    programme.rows[0].slack_column = 1;
    CHECK(the_solver_of_tests().minimise(programme, x) == "");
    REQUIRE(x.size() == 2);
    CHECK(x[0] == Approx(1));
    CHECK(x[1] == Approx(0.5));
}

}  // namespace candelabra
