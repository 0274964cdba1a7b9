// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/ripples.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("ripples and waves have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"ripples", {0.473746678, 0.286918648, 0.537258488, 0.541610492}},
        {"waves", {0.619193113, 0.404513005, 0.408570331, 0.621345712}},
        {"ripples frequency 2.5 phase 0.3", {0.963895053, 0.331635537, 0.284044437, 0.943072558}},
        {"waves frequency 3 phase 0.1", {0.905962314, 0.658949889, 0.950476843, 0.623273096}},
    });
}

TEST_CASE("waves start at POV-Ray's points", "[pattern]") {
    const auto sources = wave_sources(3);
    REQUIRE(sources.size() == 3);
    CHECK(length(sources[0].centre - Vec3(-0.60437821, 0.49204841, -0.62659025)) < 1e-8);
    CHECK(length(sources[1].centre - Vec3(-0.55257310, -0.24607534, -0.79631017)) < 1e-8);
    CHECK(sources[0].frequency == Approx(0.91911588).margin(1e-8));
    CHECK(sources[1].frequency == Approx(0.96004120).margin(1e-8));
    CHECK(sources[2].frequency == Approx(0.43316965).margin(1e-8));
    CHECK(wave_sources(-5).size() == 1);
    CHECK(wave_sources(1 << 30).size() == static_cast<std::size_t>(max_wave_sources));
}

TEST_CASE("the scene says how many points waves start at", "[pattern]") {
    const PatternUse use = pattern_of("ripples");
    const Vec3 point(1, 2, 3);
    PatternScene one;
    one.number_of_waves = 1;
    CHECK(value_at(use, point, one) != Approx(value_at(use, point)).margin(1e-3));
    CHECK(value_at(use, point, one) ==
          Approx(0.5 * (1 + cycle(length(point - wave_sources(1)[0].centre)))));
}

}  // namespace candelabra
