// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lamp_draw.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

namespace candelabra {

namespace {

constexpr auto lamps = R"(
    #declare R = seed(4);
    #for (I, 1, 3000)
        sphere { 20*<rand(R), rand(R), rand(R)> - 10, 0.01 + 0.02*rand(R) pigment { rgb 1 }
                 finish { emission 0.1 + 10*pow(rand(R), 4) } }
    #end
    plane { y, -11 pigment { rgb 1 } }
)";

}  // namespace

TEST_CASE("few lamps are looked at all", "[lamp_draw]") {
    const SharedWorld world = world_of(lamps);
    std::vector<double> weights;
    LampDraw(world->lights.luminaires)
        .chances({Vec3(0), Vec3(0, 0, 1)})
        .draw(0.5, [&](LightIndex, double weight) { weights.push_back(weight); });
    CHECK(weights == std::vector<double>(3000, 1));
}

TEST_CASE("of many lamps some are looked at, and the weights of each have the mean 1",
          "[lamp_draw]") {
    const SharedWorld world = world_of(lamps);
    const LampDraw draw(world->lights.luminaires, 200);
    const bool squares = GENERATE(false, true);
    const Vec3 from = GENERATE(Vec3(0), Vec3(0, 0, -30), Vec3(5, 5, 5));
    const LampDraw::Chances chances = draw.chances({from, Vec3(0, 0, 1), squares});
    constexpr int draws = 20000;
    std::vector<double> sums(3000, 0);
    std::size_t most = 0;
    for (int i = 0; i < draws; ++i) {
        std::size_t looks = 0;
        chances.draw((i + 0.5) / draws, [&](LightIndex lamp, double weight) {
            sums[lamp] += weight / draws;
            ++looks;
        });
        most = std::max(most, looks);
    }
    CHECK(most <= 201);
    // A chance of p is met by p * draws numbers, and one more or fewer.
    int known = 0;
    for (const double sum : sums) known += sum > 0.5 && sum < 1.5 ? 1 : 0;
    CHECK(known > 2900);
    double all = 0;
    for (const double sum : sums) all += sum;
    CHECK(all == Approx(3000).epsilon(0.02));
}

}  // namespace candelabra
