// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/linear_alpha.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<Luminaire> spheres(int count, Draw& draw) {
    std::vector<Luminaire> result;
    for (int i = 0; i < count; ++i)
        result.push_back(
            glowing(SphereEmitter{draw.point(3) + Vec3(0, 4, 0), draw.between(0.01, 0.3)},
                    draw.between(1, 9)));
    return result;
}

}  // namespace

TEST_CASE("linear alpha leaves no noise of choice where its estimates are exact",
          "[lighting][claim-6]") {
    Draw draw(1);
    for (const int count : {1, 20, 2000}) {
        const std::vector<Luminaire> luminaires = spheres(count, draw);
        const BuiltLinearAlpha built = build(LinearAlpha{}, {choices(luminaires), {}}, 1);
        const Receiver point{Vec3(0), Vec3(0, 1, 0)};
        double all = 0;
        for (const Luminaire& luminaire : luminaires) all += unoccluded(luminaire, point);
        for (std::uint32_t sample = 0; sample < 300; ++sample) {
            LightPicks picks;
            built.choose(point, {1, sample, 0, 0}, picks);
            REQUIRE(picks.size() == 1);
            CHECK(unoccluded(luminaires[picks[0].light], point) / picks[0].expected ==
                  Approx(all).epsilon(1e-9));
        }
    }
}

TEST_CASE("linear alpha picks nothing where all luminaires are below the horizon", "[lighting]") {
    Draw draw(2);
    const std::vector<Luminaire> luminaires = spheres(50, draw);
    const BuiltLinearAlpha built = build(LinearAlpha{}, {choices(luminaires), {}}, 1);
    LightPicks picks;
    built.choose({Vec3(0), Vec3(0, -1, 0)}, {}, picks);
    CHECK(picks.empty());
    CHECK(built.expected({Vec3(0), Vec3(0, -1, 0)}, {}, 3) == 0);
}

TEST_CASE("a luminaire whose centre is below the horizon is asked as long as a part of it is above",
          "[lighting][claim-9]") {
    // The paper's Figure 4, left, shows the result of the opposite.
    const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0, -1, 5), 2}),
                                               glowing(SphereEmitter{Vec3(0, 50, 0), 1})};
    const BuiltLinearAlpha built = build(LinearAlpha{}, {choices(luminaires), {}}, 1);
    CHECK(built.expected({Vec3(0), Vec3(0, 1, 0)}, {}, 0) > 0);
}

}  // namespace candelabra
