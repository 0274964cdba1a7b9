// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/every_light.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the conventional way asks each luminaire once", "[lighting]") {
    const std::vector<Luminaire> luminaires(3, glowing(SphereEmitter{Vec3(0, 3, 0), 1}));
    const BuiltEveryLight built = build(EveryLight{}, {choices(luminaires), {}}, 1);
    LightPicks picks = {{7, 0.5}};
    built.choose({Vec3(0), Vec3(0, 1, 0)}, {}, picks);
    REQUIRE(picks.size() == 4);
    for (LightIndex light = 0; light < 3; ++light) {
        CHECK(picks[light + 1].light == light);
        CHECK(picks[light + 1].expected == 1);
    }
}

}  // namespace candelabra
