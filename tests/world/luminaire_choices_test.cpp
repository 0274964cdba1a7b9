// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/luminaire_choices.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

namespace {

/// Mean of the light that arrives at the origin from above.
double mean_arriving(const LuminaireChoices& lights, LightIndex light, const LightProbe& probe) {
    constexpr int steps = 40;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
            sum += lights.arriving(light, {{Vec3(0), Vec3(0, 1, 0)}, 1e-9},
                                   {(i + 0.5) / steps, (j + 0.5) / steps}, probe);
    return sum / (steps * steps);
}

}  // namespace

TEST_CASE("what shadow rays of a survey find is the unoccluded light behind what lets it pass",
          "[world]") {
    const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0, 5, 0), 1}, 3)};
    const LuminaireChoices lights(luminaires);
    CHECK(lights.has_surface(0));
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    for (const double passes : {1.0, 0.25, 0.0}) {
        const auto pane = [&](const Ray&, double tolerance) -> std::optional<ProbeHit> {
            if (tolerance < 1) return ProbeHit{1, Vec3(0, -1, 0), 1e-9, {}, 0, passes};
            return ProbeHit{4.5, Vec3(0, -1, 0), 1e-9, 0, 3, 1};
        };
        CHECK(mean_arriving(lights, 0, pane) ==
              Approx(passes * lights.unoccluded(0, point)).epsilon(0.01));
    }
    const auto nothing = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    CHECK(mean_arriving(lights, 0, nothing) == 0);
}

TEST_CASE("triangles are exact nearby, and bounds are those of the luminaires", "[world]") {
    const std::vector<Luminaire> luminaires = {
        glowing(SphereEmitter{Vec3(0, 5, 0), 1}),
        glowing(TriangleEmitter{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)})};
    const LuminaireChoices lights(luminaires);
    CHECK(lights.size() == 2);
    CHECK_FALSE(lights.exact_nearby(0));
    CHECK(lights.exact_nearby(1));
    CHECK_FALSE(lights.falls_off());
    CHECK(lights.bounds(1).intensity == bounds(luminaires[1]).intensity);
}

}  // namespace candelabra
