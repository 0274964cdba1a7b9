// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_sphere.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the pigments of a sky lie over each other and the background", "[backdrop]") {
    SkySphere sky;
    Pigment below, above;
    below.colour = {Vec3(0.2, 0.4, 0.6), 0.2, 0.1};
    above.colour = {Vec3(0.9, 0.5, 0.1), 0.3, 0.4};
    sky.pigments = {below, above};
    const Vec3 background(0.3, 0.6, 0.9);
    const auto near = [](const Vec3& a, const Vec3& b) { return length(a - b) < 3e-5; };
    // By the rules of language 3.7 and of earlier ones, as printed by POV-Ray.
    CHECK(
        near(radiance(sky, Vec3(0, 0, 1), background, {}, false), Vec3(0.39194, 0.36339, 0.29574)));
    CHECK(
        near(radiance(sky, Vec3(0, 0, 1), background, {}, true), Vec3(0.38325, 0.37720, 0.36324)));
    sky.emission = Vec3(0);
    CHECK(radiance(sky, Vec3(0, 0, 1), Vec3(0), {}, false) == Vec3(0));
}

}  // namespace candelabra
