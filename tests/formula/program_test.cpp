// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/program.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

double result_of(Operation operation, double a, double b) {
    Program program;
    program.code = {{operation, 2, 0, 1}, {}};
    std::array<double, 3> registers = {a, b, 99};
    REQUIRE(execute(program, registers.data()));
    return registers[2];
}

}  // namespace

TEST_CASE("each operation computes", "[formula]") {
    const auto [operation, a, b, result] = GENERATE(table<Operation, double, double, double>({
        {Operation::copy, 3, 4, 3},
        {Operation::add, 3, 4, 7},
        {Operation::subtract, 3, 4, -1},
        {Operation::multiply, 3, 4, 12},
        {Operation::divide, 3, 4, 0.75},
        {Operation::divide, 3, 0, INFINITY},
        {Operation::negate, 3, 4, -3},
        {Operation::less, 3, 4, 1},
        {Operation::less, 3, 3, 0},
        {Operation::less_equal, 3, 3, 1},
        {Operation::less_equal, 3 + 1e-12, 3, 0},
        {Operation::equal, 3, 3 + 1e-12, 0},
        {Operation::not_equal, 3, 3 + 1e-12, 1},
        {Operation::greater_equal, 3, 3 + 1e-12, 0},
        {Operation::greater, 4, 3, 1},
        {Operation::both, 1e-12, 2, 1},
        {Operation::both, 0, 2, 0},
        {Operation::either, 0, 1e-12, 1},
        {Operation::either, 0, 0, 0},
        {Operation::about_less_equal, 3 + 1e-12, 3, 1},
        {Operation::about_less_equal, 3.1, 3, 0},
        {Operation::about_equal, 3, 3 + 1e-12, 1},
        {Operation::about_equal, 3, 3 + 1e-9, 0},
        {Operation::about_not_equal, 3, 3 + 1e-12, 0},
        {Operation::about_greater_equal, 3, 3 + 1e-12, 1},
        {Operation::true_both, 1e-12, 2, 0},
        {Operation::true_both, 1, 2, 1},
        {Operation::true_either, 1e-12, 1, 1},
        {Operation::true_either, 1e-12, 0, 0},
        {Operation::not_true, 1e-12, 0, 1},
        {Operation::not_true, 1, 0, 0},
        {Operation::least, 3, 4, 3},
        {Operation::greatest, 3, 4, 4},
        {Operation::power, 3, 4, 81},
        {Operation::arc_tangent, 0, -1, std::atan2(0, -1)},
        {Operation::remainder, -7, 3, -1},
        {Operation::whole_quotient, -7, 2, -3},
        {Operation::divide_unless, 3, 4, 0.75},
    }));
    INFO(static_cast<int>(operation) << ": " << a << ", " << b);
    CHECK(result_of(operation, a, b) == result);
}

TEST_CASE("a program can give up", "[formula]") {
    Program program;
    program.code = {{Operation::divide_unless, 2, 0, 1}, {Operation::refuse, 0, 2, 0}, {}};
    std::array<double, 3> zero_divisor = {1, 0, 0}, refused = {1, 2, 0}, good = {0, 2, 0};
    CHECK_FALSE(execute(program, zero_divisor.data()));
    CHECK_FALSE(execute(program, refused.data()));
    CHECK(execute(program, good.data()));
}

TEST_CASE("a loop without end is given up", "[formula]") {
    Program program;
    program.code = {{Operation::repeat, 0, 0, 0}, {}};
    double none = 0;
    CHECK_FALSE(execute(program, &none));
}

}  // namespace candelabra
