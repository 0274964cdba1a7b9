// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan.h"

#include "support/four_lamps.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("samples are as many as asked for", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(0);
    settings.samples = 3;
    CHECK(render(shot, settings).rays.camera == 3u * 45 * 37);
    const Shot dark = shot_of("sphere { <0, 0, 5>, 1 }");
    settings.samples = 0;
    settings.antialias = false;
    CHECK(render(dark, settings).rays.camera == 45u * 37);
}

TEST_CASE("a plan that is cancelled while some pixels are traced is none", "[render]") {
    const Shot shot = shot_of(four_lamps);
    CHECK(plan_of(shot, of_samples(0), [] { return false; }));
    CHECK_FALSE(plan_of(shot, of_samples(0), [] { return true; }));
}

TEST_CASE("a bound for noise is for light as the film shows it", "[render][film]") {
    const auto samples = [](const std::string& film) {
        const Shot shot = shot_of(R"(
            #version 3.7;
            camera { location <0, 2, -5> look_at 0 film { )" +
                                  film + R"( } }
            sphere { <0, 3, 0>, 0.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
            plane { y, -1 pigment { rgb 0.5 } finish { ambient 0 } }
        )");
        RenderSettings settings = of_samples(0);
        settings.width = settings.height = 16;
        settings.noise = 0.002;
        RenderState state = begin_picture(settings);
        LightLedger rays;
        REQUIRE(advance(plan_of(shot, settings), state, rays));
        std::uint64_t sum = 0;
        for (const PixelSum& pixel : state.film.pixels()) sum += pixel.samples;
        return sum;
    };
    CHECK(samples("exposure 3") > 2 * samples("exposure 0"));
    CHECK(samples("exposure -4") <= samples("exposure 0"));
}

TEST_CASE("each pixel sees all moments of the shutter, also in light without noise", "[render]") {
    // The lamp is so dim that the pilot finds no noise: pixels get few samples.
    const std::string scene = R"(
        #version 3.7;
        camera { location <0, 2, -5> look_at 0 }
        light_source { <3, 5, -5>, 1 }
        plane { y, -1 pigment { rgb 0.5 } }
        sphere { <0, 9, 0>, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1e-3 } })";
    const RenderSettings settings = small(1);
    const SharedWorld one = world_of(scene);
    CHECK(plan_of(Shot(one), settings).samples == 4);
    World moving(*one);
    for (int later = 0; later < 6; ++later) moving.shutter.emplace_back(*one);
    CHECK(plan_of(Shot(std::make_shared<World>(std::move(moving))), settings).samples == 7);
}

TEST_CASE("a small glow does not change the number of samples without antialiasing", "[render]") {
    const auto samples = [](double glow) {
        RenderSettings settings = small(0);
        settings.antialias = false;
        settings.shadow_rays = 0;
        const Shot shot = shot_of(
            "#version 3.7; camera { location <0, 2, -5> look_at 0 } "
            "light_source { <3, 5, -5>, 1 } plane { y, -1 pigment { rgb 0.5 "
            "} } sphere { 0, 1 pigment { rgb 0.8 } finish { emission " +
            std::to_string(glow) + " } }");
        const RenderPlan plan = plan_of(shot, settings);
        if (plan.samples == 1) CHECK(plan.shadow_rays.usual == 1);
        return plan.samples;
    };
    CHECK(samples(0) == 1);
    CHECK(samples(0.05) == 1);
    CHECK(samples(20) >= 4);
}

}  // namespace candelabra
