// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/kept_meters.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra {

namespace {

LampList lamps_at_meters(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::vector<float> powers(count, 1.0F);
    powers[0] = 3;
    return LampList({{"Row", count}}, numbers, powers);
}

}  // namespace

TEST_CASE("lamps stand by themselves at few points, and share nodes at many", "[relight]") {
    const LampList lamps = lamps_at_meters(2000);
    CHECK(nodes_for_points(lamps, 10).size() == 2000);
    const std::vector<LampRange> nodes = nodes_for_points(lamps, 10'000);
    CHECK(nodes.size() == 100);
    std::uint32_t at = 0;
    for (const LampRange& node : nodes) {
        CHECK(node.first == at);
        at = node.last;
    }
    CHECK(at == 2000);
}

TEST_CASE("readings are sums of the light of nodes, by means of their powers", "[relight]") {
    const LampList lamps = lamps_at_meters(3);
    Meter meter;
    meter.name = "M";
    MeterReading reading{};
    reading.places = {{{1, 2, 3}, {0, 1, 0}}};
    // Two nodes, of which each has red, green and blue light.
    reading.halves[0] = {{20}, {1, 2, 3, 4, 0, 0}};
    reading.halves[1] = {{24}, {3, 2, 3, 4, 0, 0}};
    const KeptMeters kept = kept_meters({&meter, 1}, {&reading, 1}, {{0, 2}, {2, 3}});
    REQUIRE(kept.meters.size() == 1);
    CHECK(kept.meters[0].quantity == "illuminance");
    CHECK(kept.meters[0].unit == "lx");
    CHECK(kept.meters[0].rest[0] == 22 - (2 + 2 + 3 + 4));
    const auto at = [&](std::vector<Rgb> factors) {
        return relit_readings(kept, kept.meters[0], lamps, factors)[0];
    };
    CHECK(at({Rgb(1), Rgb(1), Rgb(1)}) == 22);
    CHECK(at({Rgb(0), Rgb(0), Rgb(0)}) == 11);
    CHECK(at({Rgb(0), Rgb(0), Rgb(0.5, 9, 9)}) == 13);
    // The first lamp has three quarters of the power of its node.
    CHECK(at({Rgb(0), Rgb(1), Rgb(0)}) == 11 + 7 / 4.0);
}

TEST_CASE("ratings and shares are no sums of lamps", "[relight]") {
    Meter meter;
    for (const auto& [quantity, sum] : {std::pair{Quantity::illuminance, true},
                                        {Quantity::cylindrical, true},
                                        {Quantity::luminance, true},
                                        {Quantity::ugr, false},
                                        {Quantity::threshold_increment, false},
                                        {Quantity::daylight_factor, false}}) {
        meter.quantity = static_cast<int>(quantity);
        CHECK(is_sum_of_lamps(meter) == sum);
    }
    meter.quantity = static_cast<int>(Quantity::luminance);
    meter.road_table = "r3.csv";
    CHECK(is_sum_of_lamps(meter));
}

}  // namespace candelabra
