// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_choice.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

TEST_CASE("luminaires are picked from a cut as often as is expected", "[lighting]") {
    Draw draw(1);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 60; ++i)
        luminaires.push_back(glowing(SphereEmitter{3.0 * draw.point(), 0.05}));
    const LightTree tree(*choices(luminaires));
    const LightCut cut(tree, *choices(luminaires), {Vec3(-0.5), Vec3(0.5)}, {0.01, 8});
    const Receiver point{Vec3(0.1), Vec3(0, 1, 0)};
    CutWeights weights;
    cut.weigh(point, weights);
    constexpr int trials = 20000;
    std::vector<double> counted(luminaires.size());
    for (int i = 0; i < trials; ++i) {
        const Key key{1, static_cast<std::uint32_t>(i), 0, 0};
        const auto pick = pick_from(cut, weights, tree, point, key, (i + 0.5) / trials);
        REQUIRE(pick);
        CHECK(pick->expected == Approx(expected_from(cut, weights, tree, point, pick->light)));
        ++counted[pick->light];
    }
    double sum = 0;
    for (LightIndex light = 0; light < luminaires.size(); ++light) {
        const double expected = expected_from(cut, weights, tree, point, light);
        sum += expected;
        CHECK(std::abs(counted[light] / trials - expected) < 0.01);
    }
    CHECK(sum == Approx(1));
    weights.total = 0;
    CHECK_FALSE(pick_from(cut, weights, tree, point, {}, 0.5));
    CHECK(expected_from(cut, weights, tree, point, 3) == 0);
}

}  // namespace candelabra
