// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_calibration.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("entries of which nothing arrives count little, but not nothing", "[lighting]") {
    // Two rows of lamps far away; those at x < 0 are behind a wall.
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 20; ++i)
        luminaires.push_back(glowing(SphereEmitter{Vec3(i % 2 ? 30 : -30, 20, i - 10), 0.3}, 5));
    const LightTree tree(*choices(luminaires));
    const Box cell{Vec3(-1, -0.1, -1), Vec3(1, 0.1, 1)};
    const LightCut cut(tree, *choices(luminaires), cell, {1e-9, 64});
    double wall_passes = 0;
    const auto probe = [&](const Ray& ray, double tolerance) -> std::optional<ProbeHit> {
        if (ray.direction.x < 0 && tolerance < 5)
            return ProbeHit{5, Vec3(1, 0, 0), 0, {}, 0, wall_passes};
        LightHits met;
        for (LightIndex light = 0; light < luminaires.size(); ++light) {
            intersect(luminaires[light], {ray.origin, Vec3(0, 1, 0)}, ray.direction, met);
            if (!met.empty()) return ProbeHit{met[0].distance, -ray.direction, 0, light, 5};
        }
        return {};
    };
    std::vector<SurveyPlace> receivers;
    for (int i = 0; i < 6; ++i)
        receivers.push_back({{Vec3(0.3 * i - 0.8, 0, 0.1), Vec3(0, 1, 0)}, 1e-9});
    const std::vector<float> shares =
        arriving_shares(cut, tree, *choices(luminaires), receivers, probe);
    REQUIRE(shares.size() == cut.entries());
    for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
        const LightIndex light = tree.light(cut.cluster(entry).first);
        const bool seen = light % 2 == 1;
        CHECK(shares[entry] > 0.01f);
        CHECK((seen ? shares[entry] > 0.9f : shares[entry] < 0.1f));
        CHECK(cautious_share(shares[entry], cell, tree.light_proxy(cut.cluster(entry))) >=
              shares[entry]);
        CHECK(cautious_share(shares[entry], cell, {Vec3(0, 1, 0), 0.5}) >= 0.99f);
    }
    const auto dark = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    for (const float share : arriving_shares(cut, tree, *choices(luminaires), receivers, dark))
        CHECK(share == 1);
    // Lamps behind glass count by the light that passes the glass.
    wall_passes = 0.5;
    const std::vector<float> behind_glass =
        arriving_shares(cut, tree, *choices(luminaires), receivers, probe);
    for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
        const bool before = tree.light(cut.cluster(entry).first) % 2 == 1;
        CHECK(behind_glass[entry] > (before ? 0.9f : 0.4f));
        CHECK((before || behind_glass[entry] < 0.7f));
    }
}

}  // namespace candelabra
