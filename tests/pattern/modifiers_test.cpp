// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/modifiers.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("modifiers are read in any order", "[pattern]") {
    const PatternModifiers read =
        pattern_of("bozo octaves 3 lambda 3 omega 0.25 scale 2 turbulence <1, 2, 3>").modifiers;
    CHECK(read.turbulence == Vec3(1, 2, 3));
    CHECK(read.noise_octaves() == Octaves{3, 0.25, 3});
    CHECK(read.frequency == 1);
}

TEST_CASE("the noise of a pattern is its own, or the scene's", "[pattern]") {
    PatternModifiers modifiers;
    const PatternScene scene{NoiseGenerator::original, 10, nullptr};
    CHECK(PatternPoint{Vec3(0), modifiers, scene}.noise_generator() == NoiseGenerator::original);
    modifiers.noise_generator = 3;
    CHECK(PatternPoint{Vec3(0), modifiers, scene}.noise_generator() == NoiseGenerator::perlin);
}

}  // namespace candelabra
