// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan.h"

#include "base/unless_ended.h"
#include "support/four_lamps.h"
#include "text/message.h"

#include <catch2/catch.hpp>

#include <functional>
#include <utility>

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

TEST_CASE("light that is sent before the first sample can be ended", "[render]") {
    for (const char* settings : {"integrator { path_traced bounces 3 reflected_luminaires 400000 }",
                                 "photons { count 2000000 } integrator { path_traced bounces 3 "
                                 "reflected_luminaires 0 }"}) {
        INFO(settings);
        const Shot shot = shot_of(message("global_settings { ", settings, " } ", four_lamps, R"(
            sphere { <-2, 1, 0>, 1 pigment { rgbt 1 } interior { ior 1.5 }
                photons { target on refraction on } }
        )"));
        const std::function<bool()> at_once = [] { return true; };
        for (const int threads : {1, 2}) {
            RenderSettings picture = of_samples(1);
            picture.threads = threads;
            picture.shadow_rays = 1;  // no trials, which would send light
            CHECK_FALSE(unless_ended(at_once, [&] {
                const SentLight sent = SentLight::of(shot, 0, threads);
                if (sent.photons) sent.photons->generation(0);
                if (sent.reflected) sent.reflected->generation(0);
                return true;
            }));
            RenderState state = begin_picture(picture);
            LightLedger rays;
            RenderHooks hooks;
            hooks.ended = at_once;
            CHECK_FALSE(advance(plan_of(shot, picture), state, rays, hooks));
            CHECK(rays.camera == 0);
        }
    }
}

TEST_CASE("a plan without trials sends no reflected luminaires of its own accord", "[render]") {
    const auto plan_with = [](const char* integrator) {
        const Shot shot =
            shot_of(message("global_settings { integrator { ", integrator, " } } ", four_lamps));
        const RenderSettings settings = of_samples(0);
        return plan_without_trials(shot, settings, SentLight::of(shot, 0, 1)).sent.reflected;
    };
    CHECK(plan_with("path_traced bounces 3 reflected_luminaires 300"));
    CHECK_FALSE(plan_with("path_traced bounces 3"));
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
        return std::pair(plan.samples, plan.shadow_rays.usual);
    };
    CHECK(samples(0).first == 1);
    CHECK(samples(0.05).first == 1);
    // Two samples of many shadow rays, whose difference tells the noise, or more samples of fewer.
    const auto [number, rays] = samples(20);
    CHECK(number >= (rays > 4 ? 2 : 4));
    CHECK(static_cast<int>(number) * rays >= 16);
}

TEST_CASE("a bound on the noise begins with fewer samples where each has many shadow rays",
          "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        camera { location <0, 3, -5> look_at 0 right x }
        plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.8 } }
        #for (I, 0, 40)
            sphere { <mod(I, 7) - 3, 2, I/7>, 0.1 pigment { rgb 1 } finish { emission 3 } }
        #end)");
    const auto first = [&](int rays) {
        RenderSettings settings = small(0);
        settings.width = settings.height = 192;
        settings.antialias = false;
        settings.shadow_rays = rays;
        settings.noise = 0.02;
        const RenderPlan plan = plan_of(Shot(shot.world, {192, 192, 1}), settings);
        return std::pair(plan.samples, plan.shadow_rays.usual);
    };
    CHECK(first(0) == std::pair(4u, 16));
    CHECK(first(4) == std::pair(16u, 4));
}

}  // namespace candelabra
