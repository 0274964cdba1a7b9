// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/interval.h"

#include <catch2/catch.hpp>

#include <random>

namespace candelabra {

TEST_CASE("intervals hold the true value in 95 of 100 cases", "[meter]") {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(3, 0.5);
    int held = 0;
    constexpr int trials = 20000;
    for (int i = 0; i < trials; ++i) {
        Batches batches{};
        double mean = 0;
        for (double& each : batches) mean += (each = noise(random)) / batch_count;
        const auto [value, error] = with_interval(mean, batches);
        CHECK(value == mean);
        held += std::abs(value - 3) <= error ? 1 : 0;
    }
    CHECK(held == Approx(0.95 * trials).epsilon(0.01));
}

TEST_CASE("a grid has a minimum, a mean and a maximum, and their ratios", "[meter]") {
    const std::vector<double> values = {120, 200, 310, 250, 180, 90};
    std::vector<Batches> batches(6);
    for (std::size_t i = 0; i < values.size(); ++i) batches[i].fill(values[i]);
    const MeterSummary summary = summary_of(values, batches);
    CHECK(summary.mean.value == Approx(191.667).epsilon(1e-5));
    CHECK(summary.min.value == 90);
    CHECK(summary.least == 5);
    CHECK(summary.max.value == 310);
    CHECK(summary.greatest == 2);
    CHECK(summary.uo.value == Approx(0.469565).epsilon(1e-5));
    CHECK(summary.ud.value == Approx(0.290323).epsilon(1e-5));
    CHECK(summary.uo.error < 1e-12);
    batches[5][0] = 106;
    CHECK(summary_of(values, batches).min.error > 1);
    const std::vector<double> dark = {0, 0};
    CHECK(summary_of(dark, std::vector<Batches>(2)).uo.value == 0);
}

}  // namespace candelabra
