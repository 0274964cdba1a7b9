// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tile.h"

#include "support/four_lamps.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

TEST_CASE("a sample that takes too long ends when it is asked to, and is not counted", "[render]") {
    const std::vector<std::string> slow = {
        R"(global_settings { max_trace_level 256 adc_bailout 0 } light_source { <3, 4, -5>, 1 }
           sphere { 0, 1 pigment { rgbt 1 } finish { reflection 1 } interior { ior 1.2 } }
           box { -9, 9 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } })",
        R"(#declare F = function(x) { sum(i, 1, 3000, sum(j, 1, 3000, sin(i*j*x))) }
           plane { z, 1 pigment { average pigment_map { [1 function { F(x) }] [1 function { F(y) }] } } })",
        R"(#declare F = function(x) { sum(i, 1, 3000, sum(j, 1, 3000, sin(i*j*x)*1e-9)) }
           isosurface { function { x*x + y*y + z*z - 1 + F(x) } contained_by { box { -2, 2 } } })",
        R"(blob { threshold 0.5 #for (I, 1, 20000) sphere { sin(I)*0.2, 1, 0.01 } #end })",
    };
    for (const std::string& scene : slow) {
        INFO(scene);
        const Shot shot = shot_of("#version 3.7; camera { location -3*z angle 10 } " + scene);
        RenderSettings settings = of_samples(1);
        settings.width = settings.height = 2;
        settings.threads = 1;
        RenderState state = begin_picture(settings, 0);
        LightLedger rays;
        int asked = 0;
        RenderHooks hooks;
        hooks.ended = [&] { return ++asked > 1; };
        CHECK_FALSE(advance(plan_of(shot, settings), state, rays, hooks));
        CHECK(asked == 2);
        CHECK(state.film.at(0, 0).samples == 0);
    }
}

TEST_CASE("a pixel whose work ended at any moment goes on with no value twice or lost",
          "[render]") {
    // The values besides the colour take rays of their own, each of which the end may come in.
    const Shot shot = shot_of(R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location -5*z look_at 0 }
        light_source { <3, 5, -9>, .9 }
        sphere { <1, 2, -3>, 0.3 pigment { rgb 1 } finish { emission 3 } }
        #declare F = function(x) { sum(i, 1, 3000, sin(i*x)*1e-9) }
        isosurface { function { x*x + y*y + z*z - 1 + F(x) } contained_by { box { -2, 2 } } })");
    RenderSettings settings = of_samples(2);
    settings.width = settings.height = 3;
    settings.threads = 1;
    settings.antialias = GENERATE(false, true);
    settings.sampling_method = GENERATE(1, 2);
    CAPTURE(settings.antialias, settings.sampling_method);
    RenderHooks hooks;
    hooks.aovs = {.alpha = true, .surface = true, .lights = true, .illuminance = true};
    RenderState whole = begin_picture(settings, hooks.aovs.count(*shot.world)), broken = whole;
    LightLedger rays;
    CHECK(advance(plan_of(shot, settings), whole, rays, hooks));
    int asked = 0, last = 1, stops = 0;
    hooks.ended = [&] { return ++asked > last; };
    for (; !advance(plan_of(shot, settings), broken, rays, hooks); ++stops, last += 1) {
        asked = 0;
        REQUIRE(stops < 1000);
    }
    CHECK(stops > 5);
    CHECK(broken == whole);
}

TEST_CASE("antialiased pictures can be stopped, and made in parts", "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location -5*z look_at 0 }
        light_source { <3, 5, -9>, .9 }
        sphere { 0, 1.3 pigment { checker rgb .9 rgb .2 scale .4 } finish { reflection .2 } })");
    RenderSettings settings = small(2);
    settings.width = 70;
    settings.height = 45;
    settings.sampling_method = GENERATE(1, 2);
    CAPTURE(settings.sampling_method);
    RenderHooks hooks;
    hooks.aovs = {true, true, true};
    RenderState whole = begin_picture(settings, hooks.aovs.count(*shot.world)), broken = whole,
                parts = whole;
    LightLedger rays;
    CHECK(advance(plan_of(shot, settings), whole, rays, hooks));
    for (int i = 0; i < 3; ++i) {
        RenderState part = begin_picture(settings, hooks.aovs.count(*shot.world));
        part.shard.first_tile = i;
        part.shard.tile_step = 3;
        CHECK(advance(plan_of(shot, settings), part, rays, hooks));
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                if (part.shard.owns(x, y)) parts.film.add(part.film.index(x, y), part.film);
    }
    CHECK(parts.film.image().pixels == whole.film.image().pixels);
    for (int edge = 34; edge < 42; ++edge) {
        RenderState part = begin_picture(settings, hooks.aovs.count(*shot.world));
        part.shard.region = {13, 9, edge, edge};
        CHECK(advance(plan_of(shot, settings), part, rays, hooks));
        int others = 0;
        for (int y = 9; y < edge; ++y)
            for (int x = 13; x < edge; ++x)
                others += part.film.at(x, y).mean() != whole.film.at(x, y).mean();
        CHECK(others == 0);
    }
    std::atomic<int> asked = 0;
    hooks.cancelled = [&] { return ++asked > 30; };
    int stops = 0;
    for (; !advance(plan_of(shot, settings), broken, rays, hooks); ++stops) {
        asked = 0;
        REQUIRE(stops < 1000);
    }
    CHECK(stops > 3);
    CHECK(broken == whole);
}

TEST_CASE("samples of one picture can be taken in parts and added", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(2);
    settings.samples = 5;
    LightLedger rays;
    RenderState whole = begin_picture(settings);
    advance(plan_of(shot, settings), whole, rays, {});
    Film sum(settings.width, settings.height);
    for (const auto& [first, count] : {std::pair{3u, 2}, std::pair{0u, 1}, std::pair{1u, 2}}) {
        settings.samples = count;
        RenderState part = begin_picture(settings);
        part.shard.first_sample = first;
        advance(plan_of(shot, settings), part, rays, {});
        for (std::size_t i = 0; i < sum.pixels().size(); ++i)
            sum.pixels()[i].add(part.film.pixels()[i]);
    }
    CHECK(sum.image().pixels == whole.film.image().pixels);
}

}  // namespace candelabra
