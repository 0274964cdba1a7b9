// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/functions.h"

#include "interpret/said.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

TEST_CASE("random streams give POV-Ray's numbers", "[interpret]") {
    const auto [seed, values] = GENERATE(table<double, std::vector<double>>({
        {0, {0.00000287429429658, 0.46656368450880137, 0.24907022883395438, 0.96587604213642797}},
        {1, {0.42199287526821549, 0.48712119820693534, 0.66589621563113677}},
        {12345, {0.46656368450880137, 0.24907022883395438}},
        {-1, {0.57801287355320830, 0.44600617081066735}},
        {2.9, {0.84398287624213442}},
        {2147483647.5, {0.07801287343679296}},
        {3e9, {0.50000287441071189}},
        {-3e9, {0.50000287441071189}},
        {1e10, {0.50000287441071189}},
    }));
    RandomStreams random;
    const std::size_t stream = random.open(seed);
    for (const double value : values) CHECK(random.next(stream) == Approx(value).margin(1e-15));
    CHECK(random.known(0));
    CHECK_FALSE(random.known(1));
    CHECK_FALSE(random.known(-1));
}

TEST_CASE("streams are numbered and do not disturb each other", "[interpret]") {
    CHECK(printed("#declare A = seed(0); #declare B = seed(1); P(A) P(B) P(rand(B)) P(rand(A)) "
                  "P(rand(B))") == "0.000000 1.000000 0.421993 0.000003 0.487121");
    CHECK(printed("P(rand(5))") == "error: there is no random stream 5; seed(...) gives one\n");
}

TEST_CASE("random numbers of an attempt can be taken back", "[interpret]") {
    RandomStreams streams;
    const std::size_t a = streams.open(1), b = streams.open(2);
    const double first = streams.next(a);
    const std::size_t begin = streams.begin_attempt();
    const double second = streams.attempt(a);
    streams.attempt(b);
    streams.attempt(a);
    streams.take_back(begin);
    CHECK(streams.next(a) == second);
    CHECK(first != second);
    streams.begin_attempt(true);
    const double third = streams.attempt(a);
    const std::size_t inner = streams.begin_attempt();
    const double fourth = streams.attempt(a);
    streams.take_back(inner);
    CHECK(streams.attempt(a) == fourth);
    streams.take_back(0);
    streams.end_attempt();
    CHECK(streams.next(a) == third);
    RandomStreams fresh;
    fresh.open(2);
    CHECK(streams.next(b) == fresh.next(0));
}

}  // namespace candelabra
