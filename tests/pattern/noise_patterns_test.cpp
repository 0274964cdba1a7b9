// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/noise_patterns.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("patterns of noise have POV-Ray's values", "[pattern]") {
    check_patterns({
        {"bozo", {0.379154909, 0.511490641, 0.740099598, 0.462996606}},
        {"spotted", {0.379154909, 0.511490641, 0.740099598, 0.462996606}},
        {"bumps", {0.379154909, 0.511490641, 0.740099598, 0.462996606}},
        {"bozo noise_generator 1", {0.221593279, 0.491745692, 0.958431902, 0.392749143}},
        {"bozo noise_generator 3", {0.579303757, 0.350162878, 0.462556783, 0.399263044}},
        {"agate", {0.021174971, 0.092436838, 0.293700860, 0.685267589}},
        {"agate agate_turb 0.3 octaves 4 omega 0.7 lambda 2.2",
         {0.906542784, 0.005485340, 0.836455079, 0.003109476}},
        {"agate noise_generator 1", {0.077713335, 0.003224903, 0.488415842, 0.432498192}},
        {"agate noise_generator 3", {0.711602125, 0.989904769, 0.219871208, 0.867438162}},
        {"granite", {0.231755551, 0.224044032, 0.189103337, 0.351928650}},
        {"granite noise_generator 1", {0.251490559, 0.193205999, 0.239595647, 0.338405895}},
        {"granite noise_generator 3", {0.451459293, 0.635244638, 0.420391180, 0.559123651}},
        {"dents", {0.054506720, 0.133817550, 0.405387641, 0.099250664}},
        {"wrinkles", {0.388744728, 0.596758602, 0.761906723, 0.353780922}},
        {"wrinkles noise_generator 1", {0.354770380, 0.567091909, 0.735701713, 0.319082525}},
    });
}

TEST_CASE("a pattern without a noise generator takes the scene's", "[pattern]") {
    const PatternUse free = pattern_of("bozo"), fixed = pattern_of("bozo noise_generator 3");
    const Vec3 point(0.3, 0.7, -0.2);
    for (const NoiseGenerator generator :
         {NoiseGenerator::original, NoiseGenerator::full_range, NoiseGenerator::perlin}) {
        PatternScene scene;
        scene.noise_generator = generator;
        CHECK(value_at(free, point, scene) == Approx(noise(point, generator)));
        CHECK(value_at(fixed, point, scene) == Approx(noise(point, NoiseGenerator::perlin)));
    }
}

}  // namespace candelabra
