// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pilot.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace {

const std::string floor_and_lamps = R"(
    #version 3.7;
    camera { location <0, 3, -5> look_at 0 }
    plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.8 } }
    #for (I, 0, 40) sphere { <mod(I, 7) - 3, 2, I / 7>, 0.1 pigment { rgb 1 } finish { emission 3 } } #end
)";
const std::string checks = "plane { y, 0.01 pigment { checker rgb 0 rgb 1 scale 0.02 } }";

RenderSettings small(bool antialias) {
    RenderSettings settings;
    settings.width = settings.height = 40;
    settings.antialias = antialias;
    settings.shadow_rays = 0;
    return settings;
}

}  // namespace

TEST_CASE("more shadow rays pay where light makes the noise", "[render]") {
    CHECK(best_shadow_rays({0, 0, {}}) == 1);
    CHECK(best_shadow_rays({0, 1, {}}) == 1);
    CHECK(best_shadow_rays({0.1, 1, {}}) == 1);
    CHECK(best_shadow_rays({5, 1, {}}) == 2);
    CHECK(best_shadow_rays({1, 0, {}}) == 4);
}

TEST_CASE("the pilot tells the noise of light from that of camera rays", "[render]") {
    const World plain = world_of(floor_and_lamps), checked = world_of(checks + floor_and_lamps);
    const PilotNoise middle = pilot_noise(plain, small(false)),
                     spread = pilot_noise(checked, small(true));
    CHECK(middle.of_light > 0);
    CHECK(middle.of_camera < 0.2 * middle.of_light);
    CHECK(spread.of_camera > spread.of_light);
    CHECK(shadow_rays_per_hit(plain, small(false)).usual == 4);
    CHECK(shadow_rays_per_hit(checked, small(true)).usual < 4);
}

TEST_CASE("the number of shadow rays is as the settings say", "[render]") {
    RenderSettings settings = small(false);
    settings.shadow_rays = 7;
    const ShadowRays said = shadow_rays_per_hit(world_of(floor_and_lamps), settings);
    CHECK(said.usual == 7);
    CHECK(said.usual_noise == 0);
    const World one = world_of("sphere { 0, 1 } light_source { y, 1 }");
    CHECK(shadow_rays_per_hit(one, small(true)).usual == 1);
}
