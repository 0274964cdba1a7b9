// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_bvh.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the hierarchy's probabilities add up to 1 where everything is above the horizon",
          "[lighting]") {
    Draw draw(1);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 300; ++i)
        luminaires.push_back(glowing(emitter(i % emitter_kinds, draw.point(3) + Vec3(0, 6, 0),
                                             draw.between(0.01, 0.3), draw),
                                     draw.between(1, 9)));
    const BuiltLightBvh built = build(LightBvh{}, {choices(luminaires), {}}, 1);
    for (int i = 0; i < 50; ++i) {
        const Receiver point{draw.point(1), Vec3(0, 1, 0)};
        double sum = 0;
        for (LightIndex light = 0; light < 300; ++light) sum += built.expected(point, {}, light);
        CHECK(sum == Approx(1));
    }
}

TEST_CASE("a deep hierarchy is walked without losing luminaires", "[lighting]") {
    // Each is a quarter as far away as the one before, and as bright at the origin: a tree of more
    // than 64 levels.
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 150; ++i) {
        const double d = std::pow(0.25, i);
        luminaires.push_back(glowing(SphereEmitter{Vec3(0.1 * d, d, 0), d / 8}));
    }
    const BuiltLightBvh built = build(LightBvh{}, {choices(luminaires), {}}, 1);
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    double sum = 0;
    for (LightIndex light = 0; light < 150; ++light) {
        CHECK(built.expected(point, {}, light) > 0);
        sum += built.expected(point, {}, light);
    }
    CHECK(sum == Approx(1));
    std::vector<double> counts(150);
    constexpr int trials = 60000;
    for (std::uint32_t sample = 0; sample < trials; ++sample) {
        LightPicks picks;
        built.choose(point, {1, sample, 0, 0}, picks);
        REQUIRE(picks.size() == 1);
        counts[picks[0].light] += 1;
    }
    double chi2 = 0;
    int groups = 0;
    for (LightIndex light = 0; light < 150; ++light) {
        const double expected = trials * built.expected(point, {}, light);
        if (expected < 10) continue;
        chi2 += (counts[light] - expected) * (counts[light] - expected) / expected;
        ++groups;
    }
    CHECK(groups > 10);
    CHECK(chi2 < groups + 5 * std::sqrt(2.0 * groups));
}

TEST_CASE("of equal lamps, the nearer one is picked more often", "[lighting]") {
    const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0, 10, 0), 0.1}),
                                               glowing(SphereEmitter{Vec3(0, 2, 0), 0.1})};
    const BuiltLightBvh built = build(LightBvh{}, {choices(luminaires), {}}, 1);
    CHECK(built.expected({Vec3(0), Vec3(0, 1, 0)}, {}, 1) == Approx(25.0 / 26).epsilon(0.01));
}

TEST_CASE("the tree that finds what paired rays meet counts as memory", "[lighting]") {
    const std::vector<Luminaire> luminaires(100, glowing(SphereEmitter{Vec3(0, 2, 0), 0.1}));
    const BuiltLightBvh alone(*choices(luminaires)), paired(*choices(luminaires), LightBvh{true});
    CHECK(paired.paired());
    CHECK(paired.memory_bytes() == alone.memory_bytes() + paired.tree().memory_bytes());
}

}  // namespace candelabra
