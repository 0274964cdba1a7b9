// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "support/four_lamps.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

TEST_CASE("the adaptive scheme has no bias", "[render][statistics]") {
    // Small bright objects that few rays hit would bias a scheme that uses a pixel's own samples.
    const Shot shot = shot_of(R"(
        camera { orthographic location <0, 0, -9> right 10*x up 10*y }
        #declare R = seed(1);
        #for (I, 1, 150)
            sphere { <10*rand(R) - 5, 10*rand(R) - 5, 0>, 0.02 + 0.05*rand(R) pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
        #end
        sphere { <0, 0, 99>, 1 pigment { rgb 1 } finish { emission 1 } }  // leaves light to chance
    )");
    RenderSettings settings;
    settings.width = settings.height = 24;
    settings.samples = 2000;
    const auto mean = [&] {
        double sum = 0;
        for (const Rgb& pixel : render(shot, settings).image.pixels) sum += pixel.r;
        return sum / (24 * 24);
    };
    const double exact = mean();
    settings.samples = 0;
    double sum = 0, squares = 0;
    const int runs = 40;
    for (settings.seed = 1; settings.seed <= runs; ++settings.seed) {
        const double m = mean();
        sum += m;
        squares += m * m;
    }
    const double average = sum / runs;
    const double error = std::sqrt((squares / runs - average * average) / (runs - 1));
    CHECK(std::abs(average - exact) < 4 * error + 1e-4);
}

TEST_CASE("a picture with photons has the same bytes however it is made", "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        global_settings { photons { count 1500 } radiosity { } }
        camera { location <0, 3, -8> look_at <0, 1, 0> right x up y angle 50 }
        light_source { <5, 9, 1>, rgb 0.5 photons { refraction on } }
        plane { y, 0 pigment { rgb 0.9 } }
        sphere { <0, 1, 0>, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on } }
        #for (I, 0, 11)
            sphere { <2, 2.4, 0>, 0.2 rotate 30*I*y pigment { rgb <1, 0.8, 0.5> } finish { emission 6 } }
        #end)");
    RenderSettings settings = small(1);
    settings.samples = 20;
    LightLedger rays;
    RenderState whole = begin_picture(settings), broken = whole;
    advance(plan_of(shot, settings), whole, rays, {});
    settings.threads = 3;
    std::atomic<int> asked = 0;
    RenderHooks hooks;
    hooks.cancelled = [&] { return ++asked > 200; };
    for (int stops = 0; !advance(plan_of(shot, settings), broken, rays, hooks); ++stops) {
        asked = 0;
        REQUIRE(stops < 1000);
    }
    CHECK(broken == whole);
    Film sum(settings.width, settings.height);
    for (const auto& [first, count] : {std::pair{18u, 2}, std::pair{0u, 5}, std::pair{5u, 13}}) {
        settings.samples = count;
        RenderState part = begin_picture(settings);
        part.shard.first_sample = first;
        advance(plan_of(shot, settings), part, rays, {});
        for (std::size_t i = 0; i < sum.pixels().size(); ++i)
            sum.pixels()[i].add(part.film.pixels()[i]);
    }
    CHECK(sum.image().pixels == whole.film.image().pixels);
}

TEST_CASE("lights are counted by statement when that is asked for, the same by any threads",
          "[render]") {
    const Shot shot = shot_of(four_lamps + std::string("light_source { 5*y, 0.1 }"));
    REQUIRE(shot.world->provenance.light_statements.size() == 2);
    RenderHooks hooks;
    hooks.counts_lights = true;
    const LightLedger one = render(shot, small(1), hooks).rays,
                      three = render(shot, small(3), hooks).rays;
    REQUIRE(one.lights.size() == 3);
    std::uint64_t rays = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(one.lights[i].light == three.lights[i].light);
        CHECK(one.lights[i].rays == three.lights[i].rays);
        rays += one.lights[i].rays;
    }
    CHECK(rays == one.shadow);
    CHECK(one.lights[shot.world->provenance.statement_of_light[0]].light.value() > 0);
    CHECK(one.lights[shot.world->provenance.statement_of_luminaire[0]].light.value() > 0);
    CHECK(render(shot, small(1)).rays.lights.empty());
}

}  // namespace candelabra
