// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/running_sums.h"

#include <catch2/catch.hpp>

#include <array>

namespace candelabra {

TEST_CASE("an index is drawn from sums in proportion to its weight", "[base]") {
    const std::array<double, 5> sums = {0, 1, 1, 4, 4};
    const std::span<const double> all(sums);
    CHECK(drawn_share(all, 0.0).index == 1);
    CHECK(drawn_share(all, 0.2).index == 1);
    CHECK(drawn_share(all, 0.2).within == Approx(0.8));
    CHECK(drawn_share(all, 0.25).index == 3);
    CHECK(drawn_share(all, 1.0).index == 3);
    CHECK(weight_of(all, 3) == 3);
    CHECK(weight_of(all, 4) == 0);
    CHECK(share_of(all, 1) == 0.25);
}

TEST_CASE("an index is chosen from weights in proportion to them, and never without one",
          "[base]") {
    const std::array<float, 5> weights = {0, 1, 0, 3, 0};
    const auto chosen = [&](double target) {
        return choose(std::span<const float>(weights), target);
    };
    CHECK(chosen(0).index == 1);
    CHECK(chosen(0.9).index == 1);
    CHECK(chosen(1).index == 3);
    CHECK(chosen(3.9).passed);
    CHECK(chosen(3.9).weight == 3);
    // Rounding may carry the target past the end.
    CHECK(chosen(4).index == 3);
    CHECK_FALSE(chosen(4).passed);
    double target = 2.5;
    choose(std::span<const float>(weights), target);
    CHECK(target == 1.5);
    CHECK(choose(std::span<const double>(), target).weight == 0);
}

}  // namespace candelabra
