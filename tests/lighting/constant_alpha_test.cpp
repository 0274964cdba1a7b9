// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/constant_alpha.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("constant alpha picks one of all luminaires, each as often", "[lighting][claim-5]") {
    const std::vector<Luminaire> luminaires(5, glowing(SphereEmitter{Vec3(0, 3, 0), 1}));
    const BuiltConstantAlpha built = build(ConstantAlpha{}, {choices(luminaires), {}}, 1);
    std::array<int, 5> counts{};
    for (std::uint32_t sample = 0; sample < 5000; ++sample) {
        LightPicks picks;
        built.choose({Vec3(0), Vec3(0, 1, 0)}, {1, sample, 0, 0}, picks);
        REQUIRE(picks.size() == 1);
        CHECK(picks[0].expected == Approx(0.2));
        ++counts[picks[0].light];
    }
    for (const int count : counts) CHECK(std::abs(count - 1000) < 150);
}

}  // namespace candelabra
