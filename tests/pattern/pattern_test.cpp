// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/pattern.h"

#include "pattern/values.h"

#include <set>

namespace candelabra {

TEST_CASE("every pattern has a value everywhere", "[pattern]") {
    for (std::size_t kind = 0; kind < Kinds<Pattern>::count; ++kind) {
        PatternUse use;
        use.pattern = Kinds<Pattern>::make(kind);
        name_pattern(use.pattern, use.modifiers, use.wave);
        INFO(Kinds<Pattern>::infos[kind]->name);
        std::set<double> seen;
        for (const Vec3& p : {Vec3(0), Vec3(0.3, 0.7, -0.2), Vec3(-5, 4, 3.5), Vec3(1e17),
                              Vec3(-1e17, 1, 1e9), Vec3(NAN), Vec3(1e300)}) {
            const double value = value_at(use, p);
            CHECK_FALSE(std::isnan(value));
            CHECK((value >= -0.1 && value <= 6.1));
            seen.insert(value);
        }
    }
}

TEST_CASE("patterns say what makes them differ from the others", "[pattern]") {
    CHECK(choices(Brick{}) == 2);
    CHECK(choices(CubicPattern{}) == 6);
    CHECK(choices(Bozo{}) == 0);
    CHECK(displaced(Bozo{}));
    CHECK_FALSE(displaced(Marble{}));
    PatternModifiers modifiers;
    Waveform wave;
    name_pattern(Wood{}, modifiers, wave);
    CHECK(std::holds_alternative<TriangleWave>(wave));
    CHECK(modifiers.frequency == 1);
    name_pattern(Checker{}, modifiers, wave);
    CHECK(std::holds_alternative<TriangleWave>(wave));
    CHECK(modifiers.frequency == 0);
}

}  // namespace candelabra
