// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/builder.h"

#include "formula/formula.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

using Operand = ProgramBuilder::Operand;

TEST_CASE("a program is built from operands", "[formula]") {
    ProgramBuilder builder;
    const Operand x = builder.input(), y = builder.input();
    const Operand product = builder.emit(Operation::multiply, x, y);
    const Operand sum = builder.emit(Operation::add, product, builder.constant(1));
    const std::array results = {sum, x, builder.constant(7)};
    const Formula formula(builder.finish(results));
    CHECK(formula.parameters() == 2);
    CHECK(formula.results() == 3);
    std::array<double, 3> out;
    REQUIRE(formula.run(std::array{3.0, 5.0}.data(), out.data()));
    CHECK(out == std::array{16.0, 3.0, 7.0});
}

TEST_CASE("what is known is computed at once", "[formula]") {
    ProgramBuilder builder;
    const Operand a = builder.constant(2), b = builder.constant(3);
    const Operand power = builder.emit(Operation::power, a, b);
    REQUIRE(builder.known(power));
    CHECK(*builder.known(power) == 8);
    CHECK(*builder.known(builder.apply(*function_number("abs"), builder.constant(-4))) == 4);
    CHECK(*builder.known(builder.emit(Operation::negate, a)) == -2);
    CHECK(*builder.known(builder.divide_unless(a, builder.constant(4))) == 0.5);
    CHECK(builder.here() == 0);
    CHECK(builder.known(builder.divide_unless(a, builder.constant(0))) == nullptr);
    CHECK(builder.constant(0) != builder.constant(-0.0));
}

TEST_CASE("registers are used again", "[formula]") {
    ProgramBuilder builder;
    Operand sum = builder.input();
    for (int i = 0; i < 1000; ++i) {
        const Operand next = builder.emit(Operation::add, sum, builder.constant(1));
        builder.release(sum);
        sum = next;
    }
    CHECK(builder.fits());
    const Program program = builder.finish({&sum, 1});
    CHECK(program.registers <= 4);
    CHECK(Formula(program).value(std::array{0.5}) == 1000.5);
}

TEST_CASE("jumps lead where they should", "[formula]") {
    ProgramBuilder builder;
    const Operand x = builder.input(), result = builder.variable();
    const std::size_t other = builder.jump_unless(x);
    builder.assign(result, builder.constant(1));
    const std::size_t end = builder.jump();
    builder.land(other);
    builder.assign(result, builder.constant(2));
    builder.land(end);
    const Formula formula(builder.finish({&result, 1}));
    CHECK(formula.value(std::array{5.0}) == 1);
    CHECK(formula.value(std::array{0.0}) == 2);
}

TEST_CASE("a program calls formulas", "[formula]") {
    const auto swapped = make_handle<Formula>(2, 2, [](const double* in, double* out) {
        const double first = in[0];
        out[0] = in[1];
        out[1] = first;
        return first != 0;
    });
    ProgramBuilder builder;
    const std::array inputs = {builder.input(), builder.input()};
    const Operand first = builder.call(swapped, inputs);
    const Operand second = ProgramBuilder::following(first, 1);
    const std::array results = {builder.emit(Operation::subtract, first, second)};
    const Formula formula(builder.finish(results));
    CHECK(formula.depth() == 2);
    CHECK(formula.value(std::array{2.0, 7.0}) == 5);
    CHECK(std::isnan(formula.value(std::array{0.0, 7.0})));
}

TEST_CASE("a program that is too long is not made", "[formula]") {
    ProgramBuilder builder;
    Operand sum = builder.input();
    for (int i = 0; i < 70000; ++i) {
        const Operand next = builder.emit(Operation::add, sum, sum);
        builder.release(sum);
        sum = next;
    }
    CHECK_FALSE(builder.fits());
}

TEST_CASE("lists of values are folded and chosen from", "[formula]") {
    const auto value = [](auto emit, std::vector<double> arguments) {
        ProgramBuilder builder;
        std::vector<Operand> inputs;
        for (std::size_t i = 0; i < arguments.size(); ++i) inputs.push_back(builder.input());
        const Operand result = emit(builder, inputs);
        return Formula(builder.finish({&result, 1})).value(arguments);
    };
    const auto least = [](ProgramBuilder& builder, const auto& inputs) {
        return builder.fold(Operation::least, inputs);
    };
    const auto select = [](ProgramBuilder& builder, const auto& inputs) {
        return builder.select(inputs);
    };
    CHECK(value(least, {3, 1, 2}) == 1);
    CHECK(value(least, {3}) == 3);
    CHECK(value(select, {-1, 5, 6}) == 5);
    CHECK(value(select, {0, 5, 6}) == 6);
    CHECK(value(select, {-1, 5, 6, 7}) == 5);
    CHECK(value(select, {0, 5, 6, 7}) == 6);
    CHECK(value(select, {1, 5, 6, 7}) == 7);
    for (int exponent = 0; exponent <= 8; ++exponent) {
        const auto power = [&](ProgramBuilder& builder, const auto& inputs) {
            return builder.whole_power(inputs[0], exponent);
        };
        CHECK(value(power, {-3}) == std::pow(-3, exponent));
    }
}

TEST_CASE("a pinned register is not used for others", "[formula]") {
    ProgramBuilder builder;
    const Operand counter = builder.variable();
    builder.pin(counter);
    builder.release(counter);
    CHECK(builder.variable() != counter);
    builder.unpin(counter);
    CHECK(builder.variable() == counter);
}

}  // namespace candelabra
