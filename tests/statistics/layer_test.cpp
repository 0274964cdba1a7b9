// SPDX-License-Identifier: GPL-3.0-or-later
// No light of many small lamps is lost in sums, or by what the samplers keep in single precision.

#include "support/means.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Compares the light below a layer of lamps with that of a formula.
void check_layer(int across, const Declares& declares, std::size_t instances) {
    const double step = 32.0 / across, radius = step / 20, radiance = 100;
    const Vec3 point(0.03, 0, -0.05);
    double expected = 0;
    for (int i = 0; i < across; ++i)
        for (int k = 0; k < across; ++k) {
            const Vec3 lamp((i - (across - 1) / 2.0) * step, 1, (k - (across - 1) / 2.0) * step);
            expected += radiance * radius * radius / std::pow(length(lamp - point), 3);
        }
    const Ray ray{point + Vec3(0, 0.5, 0), Vec3(0, -1, 0)};
    LightBvh bvh;
    bvh.mis = true;
    for (const LightSampler& sampler : {LightSampler{LightOctree{}}, LightSampler{bvh}}) {
        const Shot shot = shot_of_file("tests/statistics/layer.pov", declares, sampler, 16);
        CHECK(shot.world->geometry.instances.size() == instances);
        const Mean seen = mean_seen(shot, ray, 20000);
        CAPTURE(expected, seen.value, seen.error, sampler.index());
        CHECK(seen.error < 0.01 * expected);
        CHECK(agree(seen, {expected, 0}));
    }
}

}  // namespace

TEST_CASE("a layer of 160,000 small lamps gives the light that a formula says", "[statistics]") {
    check_layer(400, {}, 0);
}

TEST_CASE("a layer of 810,000 lamps by instances gives the light that a formula says",
          "[statistics]") {
    check_layer(900, {{"Across", 900.0}, {"Placed", 1.0}}, 2025);
}

}  // namespace candelabra
