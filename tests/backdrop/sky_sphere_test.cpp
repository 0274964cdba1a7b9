// SPDX-License-Identifier: GPL-3.0-or-later
#include "backdrop/sky_sphere.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the pigments of a sky lie over each other and the background", "[backdrop]") {
    SkySphere sky;
    Pigment below, above;
    below.colour = {Rgb(0.2, 0.4, 0.6), 0.2, 0.1};
    above.colour = {Rgb(0.9, 0.5, 0.1), 0.3, 0.4};
    sky.pigments = {below, above};
    const Rgb background(0.3, 0.6, 0.9);
    const auto near = [](const Rgb& a, const Rgb& b) { return length(a - b) < 3e-5; };
    // By the rules of language 3.7 and of earlier ones, as printed by POV-Ray.
    CHECK(
        near(radiance(sky, Vec3(0, 0, 1), background, {}, false), Rgb(0.39194, 0.36339, 0.29574)));
    CHECK(near(radiance(sky, Vec3(0, 0, 1), background, {}, true), Rgb(0.38325, 0.37720, 0.36324)));
    sky.emission = Rgb(0);
    CHECK(radiance(sky, Vec3(0, 0, 1), Rgb(0), {}, false) == Rgb(0));
}

}  // namespace candelabra
