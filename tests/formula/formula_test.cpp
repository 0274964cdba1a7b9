// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/formula.h"

#include "formula/builder.h"

#include <catch2/catch.hpp>

#include <thread>

namespace candelabra {

TEST_CASE("a formula may be code of C++", "[formula]") {
    const Formula formula(1, 1, [](const double* in, double* out) {
        out[0] = in[0] * 2;
        return in[0] < 10;
    });
    CHECK(formula.value(std::array{4.0}) == 8);
    CHECK(std::isnan(formula.value(std::array{40.0})));
    CHECK(formula.depth() == 1);
}

TEST_CASE("a formula with many registers runs in many threads", "[formula]") {
    ProgramBuilder builder;
    const auto x = builder.input();
    std::vector<ProgramBuilder::Operand> squares;
    for (int i = 0; i < 200; ++i)
        squares.push_back(builder.emit(Operation::multiply, x, builder.constant(i)));
    auto sum = builder.constant(0);
    for (const auto square : squares) sum = builder.emit(Operation::add, sum, square);
    const Formula formula(builder.finish({&sum, 1}));
    std::array<double, 4> results{};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < results.size(); ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k < 1000; ++k)
                results[i] += formula.value(std::array{static_cast<double>(i)});
        });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < results.size(); ++i)
        CHECK(results[i] == 19900.0 * 1000 * static_cast<double>(i));
}

}  // namespace candelabra
