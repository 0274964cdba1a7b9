// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/enclosure.h"

#include "formula/formula.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Returns a program of two inputs that consists of one operation.
Program program_of(Operation operation) {
    Program program;
    program.code = {{operation, 2, 0, 1}, {}};
    program.inputs = 2;
    program.registers = 3;
    program.results = 1;
    program.result[0] = 2;
    return program;
}

}  // namespace

TEST_CASE("each operation on intervals holds its values and slopes", "[formula]") {
    const int number = GENERATE(range(int(Operation::add), static_cast<int>(Operation::apply)));
    const auto operation = static_cast<Operation>(number);
    INFO(number);
    const Program program = program_of(operation);
    Draw draw(3);
    for (int i = 0; i < 500; ++i) {
        const auto place = [&] {
            const double x = draw.between(-3, 3);
            return i % 3 == 0 ? std::round(x) : x;
        };
        const double a = place(), b = place(), size = i % 7 == 0 ? 0 : draw.between(0, 1);
        const double da = draw.between(-1, 1), db = i % 2 == 0 ? 0 : draw.between(-1, 1);
        const auto along = [&](double start, double speed) {
            const double end = start + size * speed;
            return Enclosure{{std::min(start, end), std::max(start, end)}, {speed, speed}};
        };
        std::array<Enclosure, 3> r = {along(a, da), along(b, db), {}};
        if (!enclose(program, r.data())) continue;
        double before = NAN;
        for (int k = 0; k <= 20; ++k) {
            const double s = size * k / 20;
            std::array<double, 3> at = {a + s * da, b + s * db, 0};
            REQUIRE(execute(program, at.data()));
            const double slack = 1e-9 * (1 + std::abs(at[2]));
            if (std::isfinite(at[2]))
                CHECK((at[2] >= r[2].value.low - slack && at[2] <= r[2].value.high + slack));
            const double slope = (at[2] - before) / (size / 20);
            if (std::isfinite(slope))
                CHECK((slope >= r[2].slope.low - 1e-4 * (1 + std::abs(slope)) &&
                       slope <= r[2].slope.high + 1e-4 * (1 + std::abs(slope))));
            before = at[2];
        }
    }
}

TEST_CASE("beyond 32 bits the bounds of a whole quotient are unknown", "[formula]") {
    const auto bounds = [](double low, double high) {
        return enclosed(Operation::whole_quotient, {{low, high}, {1, 1}}, Enclosure::constant(0.5));
    };
    CHECK(bounds(1e9, 2e9) == Enclosure::unknown());
    CHECK(bounds(1, 2).value == Bounds{2, 4});
}

TEST_CASE("a square is not below 0, and is told from a product", "[formula]") {
    const Enclosure around{{-2, 1}, {1, 1}};
    std::array<Enclosure, 3> r = {around, around, {}};
    Program program = program_of(Operation::multiply);
    REQUIRE(enclose(program, r.data()));
    CHECK(r[2].value == Bounds{-2, 4});
    program.code[0].b = 0;
    REQUIRE(enclose(program, r.data()));
    CHECK(r[2].value == Bounds{0, 4});
    CHECK(r[2].slope == Bounds{-4, 2});
}

TEST_CASE("where a condition is not certain, both ways are taken", "[formula]") {
    Program program;  // x < 0 ? 5 : x
    program.code = {{Operation::less, 2, 0, 1}, {Operation::jump_unless, 4, 2},
                    {Operation::copy, 3, 4},    {Operation::jump, 5},
                    {Operation::copy, 3, 0},    {}};
    program.inputs = 1;
    program.constants = {0};
    program.registers = 5;
    std::array<Enclosure, 5> r{};
    r[4] = Enclosure::constant(5);
    const auto value = [&](double low, double high) {
        r[0] = {{low, high}, {1, 1}};
        REQUIRE(enclose(program, r.data()));
        return r[3];
    };
    CHECK(value(-2, -1) == Enclosure::constant(5));
    CHECK(value(1, 2) == Enclosure{{1, 2}, {1, 1}});
    CHECK(value(-1, 2) == Enclosure{{-1, 5}, all_numbers});
}

TEST_CASE("of code of C++ nothing is known, and of formulas that call it", "[formula]") {
    const Formula code(2, 1, [](const double*, double*) { return true; });
    std::array<Enclosure, 2> in{};
    Enclosure out;
    CHECK_FALSE(code.enclose(in.data(), &out));
    const Formula sum(program_of(Operation::add));
    in = {Enclosure{{1, 2}, {1, 1}}, Enclosure{{3, 4}, {0, 0}}};
    REQUIRE(sum.enclose(in.data(), &out));
    CHECK(out == Enclosure{{4, 6}, {1, 1}});
}

}  // namespace candelabra
