// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pilot.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

PilotNoise noise_of(double light, double camera) {
    PilotNoise noise;
    noise.of_light = light;
    noise.of_camera = camera;
    return noise;
}

}  // namespace

TEST_CASE("light that hardly differs from sample to sample is quiet", "[render]") {
    const auto quiet = [](const std::string& script) {
        RenderSettings settings;
        settings.width = settings.height = 48;
        settings.shadow_rays = 0;
        return pilot(shot_of("camera { location <0, 3, -6> look_at 0 } box { <-9, -2, -9>, <9, -1, "
                             "9> pigment { rgb 0.8 } } " +
                             script),
                     settings)
            .quiet;
    };
    const std::string lamp = "light_source { <5, 9, -5>, rgb 1 } ";
    const auto blob = [](double emission) {
        return "blob { threshold 0.5 sphere { 0, 1, 2 } pigment { rgb 1 } finish { emission " +
               std::to_string(emission) + " } }";
    };
    CHECK(quiet(lamp + blob(0.05)));
    CHECK_FALSE(quiet(lamp + blob(20)));
    CHECK_FALSE(quiet(lamp));  // without randomness no pixels are tried
}

TEST_CASE("more shadow rays pay where light makes the noise", "[render]") {
    CHECK(best_shadow_rays(noise_of(0, 0)) == 1);
    CHECK(best_shadow_rays(noise_of(0, 1)) == 1);
    CHECK(best_shadow_rays(noise_of(0.1, 1)) == 1);
    CHECK(best_shadow_rays(noise_of(5, 1)) == 2);
    CHECK(best_shadow_rays(noise_of(1, 0)) == 4);
    CHECK(best_shadow_rays(noise_of(1, 0), 2) == 8);
}

TEST_CASE("the pilot tells the noise of light from that of camera rays", "[render]") {
    const Shot plain = shot_of(floor_and_lamps), checked = shot_of(checks + floor_and_lamps);
    const PilotNoise middle = pilot_noise(plain, small(false)),
                     spread = pilot_noise(checked, small(true));
    CHECK(middle.of_light > 0);
    CHECK(middle.of_camera < 0.2 * middle.of_light);
    CHECK(spread.of_camera > spread.of_light);
    CHECK(pilot(checked, small(true)).shadow_rays.usual < 4);
}

TEST_CASE("more shadow rays pay if they make less noise in the same time", "[render]") {
    PilotNoise few = noise_of(4, 0), many = noise_of(1, 0);
    CHECK_FALSE(more_rays_pay(few, many));  // nothing was tried
    few.places = many.places = 10;
    few.rays = 100;
    many.rays = 300;
    CHECK(more_rays_pay(few, many));
    many.rays = 500;
    CHECK_FALSE(more_rays_pay(few, many));
    // What choosing among lights costs at each hit is a cost of both.
    few.of_hits.hits = many.of_hits.hits = 100;
    CHECK(more_rays_pay(few, many));
}

TEST_CASE("where all rays of a pixel are equal, hits get many shadow rays if these pay",
          "[render]") {
    const auto found = [](const std::string& script, int size, bool antialias) {
        const Shot shot = square_shot(world_of(script), size);
        RenderSettings settings = small(antialias);
        settings.width = settings.height = size;
        return pilot(shot, settings);
    };
    const Pilot many = found(floor_and_lamps, 192, false);
    CHECK(many.shadow_rays.usual == 16);
    CHECK(many.many_rays);
    // Antialiasing and a lens move the rays, and the trial would take long in a tiny picture.
    const std::string lens =
        "#default { finish { ambient 0 } } camera { location <0, 3, -5> "
        "look_at 0 aperture 0.5 blur_samples 4 focal_point 0 } ";
    for (const Pilot& few : {found(floor_and_lamps, 192, true), found(floor_and_lamps, 40, false),
                             found(floor_and_lamps + lens, 192, false)}) {
        CHECK(few.shadow_rays.usual <= 4);
        CHECK_FALSE(few.many_rays);
    }
    // Most noise is that of the directions in which fog scatters light.
    const std::string haze =
        "media { scattering { 1, 0.2 } } sphere { <0, 2, 9>, 1 pigment { rgb 1 } finish { "
        "emission 20 } } ";
    CHECK_FALSE(found(floor_and_lamps + haze, 192, false).many_rays);
}

TEST_CASE("the number of shadow rays is as the settings say", "[render]") {
    RenderSettings settings = small(false);
    settings.shadow_rays = 7;
    const ShadowRays said = pilot(shot_of(floor_and_lamps), settings).shadow_rays;
    CHECK(said.usual == 7);
    CHECK(said.usual_noise == 0);
    const Shot one = shot_of("sphere { 0, 1 } light_source { y, 1 }");
    CHECK(pilot(one, small(true)).shadow_rays.usual == 1);
}

TEST_CASE("paths pay if they make less noise in the same time", "[render]") {
    PilotNoise reflected = noise_of(1, 0), paths = noise_of(2, 0);
    CHECK_FALSE(paths_pay(reflected, paths, 0));  // nothing was tried
    reflected.places = paths.places = 10;
    reflected.rays = paths.rays = 400;
    CHECK_FALSE(paths_pay(reflected, paths, 0));
    // A sample takes 10 rays, and twice as long to the same noise by paths.
    CHECK_FALSE(paths_pay(reflected, paths, 9));
    CHECK(paths_pay(reflected, paths, 11));
    // What choosing among lights costs at each hit is a cost of both ways.
    reflected.of_hits.hits = paths.of_hits.hits = 400;
    CHECK_FALSE(paths_pay(reflected, paths, 39));
    CHECK(paths_pay(reflected, paths, 41));
    reflected.of_hits.hits = paths.of_hits.hits = 0;
    reflected.rays = 900;
    CHECK(paths_pay(reflected, paths, 0));
}

TEST_CASE("reflected luminaires are left out where paths pay, unless the scene asks for them",
          "[render]") {
    const auto by_paths = [](const std::string& said, const std::string& scene, int size) {
        const Shot shot =
            square_shot(world_of("#version 3.7; global_settings { integrator { "
                                 "path_traced { " +
                                 said + " } } } #default { finish { ambient 0 } } " + scene),
                        size);
        RenderSettings settings = small(true);
        settings.width = settings.height = size;
        return pilot(shot, settings, SentLight::of(shot, 0, 1)).by_paths;
    };
    // All light of a room comes by way of its ceiling; a yard is lit by its lamps.
    const std::string room =
        "camera { location <0, 1, -2.5> look_at <0, 0.5, 0> } box { <-3, 0, -3>, <3, 3, 3> pigment "
        "{ rgb 0.8 } } disc { <0, 2.2, 0>, y, 1 pigment { rgb 0 } } sphere { <0, 2.5, 0>, 0.1 "
        "pigment { rgb 1 } finish { diffuse 0 emission 90 } }";
    const std::string yard =
        "camera { location <0, 3, -6> look_at 0 } box { <-20, -1, -20>, <20, 0, 20> pigment { rgb "
        "0.3 } } #for (I, -3, 3) box { <I, 0, 0>, <I + 0.5, 1, 1> pigment { rgb 0.3 } } sphere { "
        "<I, 2, -1>, 0.1 pigment { rgb 1 } finish { diffuse 0 emission 9 } } #end";
    CHECK_FALSE(by_paths("", room, 64));
    // In a tiny picture, to send the light would take longer than all paths.
    CHECK(by_paths("", yard, 16));
    // Too few pixels would tell which way has less noise.
    CHECK(by_paths("", room, 24));
    CHECK_FALSE(by_paths("reflected_luminaires 500", yard, 16));
}

}  // namespace candelabra
