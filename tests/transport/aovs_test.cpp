// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/aovs.h"

#include "render/render.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

RenderState made(const Shot& shot, const Aovs& aovs, int samples = 4) {
    RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    settings.samples = samples;
    RenderState state = begin_picture(settings, aovs.count(*shot.world));
    RenderHooks hooks;
    hooks.aovs = aovs;
    LightLedger rays;
    CHECK(advance(plan_of(shot, settings), state, rays, hooks));
    return state;
}

Rgb light(const RenderState& state, const Aovs& aovs, std::size_t pixel, std::size_t which) {
    Rgb result;
    for (int c = 0; c < 3; ++c)
        result[c] =
            state.film.extra(pixel)[aovs.first_light() + 3 * which + static_cast<std::size_t>(c)]
                .value() /
            state.film.pixels()[pixel].samples;
    return result;
}

/// Mirrors, coloured glass, layers, fog and facets, so that light reaches the camera in all ways.
const std::string room = R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }
#default { finish { ambient 0 } }
camera { location <0, 1, -6> look_at <0, 0.5, 0> }
fog { distance 40 rgb 0 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.6, 0.3, 0.2> } finish { reflection 0.3 } }
sphere { <-1.5, 0, 0>, 1 pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { specular 0.5 reflection { 0.1, 0.4 fresnel } conserve_energy } interior { ior 1.4 } }
sphere { <1.5, 0, 0>, 1 texture { pigment { rgb 0.7 } } texture { pigment { rgbt <1, 0, 0, 0.5> } finish { phong 1 } } }
)";
const std::string lamps[] = {
    "light_source { <-4, 6, -4>, rgb <1, 0.8, 0.5> }\n",
    "light_source { <4, 5, -3>, rgb <0.2, 0.4, 1> spotlight point_at 0 }\n",
    "sphere { <0, 2, 0.5>, 0.3 pigment { rgb 1 } finish { diffuse 0 emission <2, 3, 1> } }\n",
};

}  // namespace

TEST_CASE("the light of all statements together is the picture", "[render]") {
    const Shot shot = shot_of(room + lamps[0] + lamps[1] + lamps[2]);
    REQUIRE(shot.world->provenance.light_statements.size() == 3);
    Aovs aovs;
    aovs.lights = true;
    const RenderState state = made(shot, aovs);
    int lit = 0;
    for (std::size_t i = 0; i < state.film.pixels().size(); ++i) {
        Rgb sum(0);
        for (std::size_t k = 0; k < 3; ++k) sum += light(state, aovs, i, k);
        const Rgb seen = state.film.pixels()[i].mean();
        lit += seen.r > 0.01;
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(seen[c]).margin(1e-9));
    }
    CHECK(lit > 200);
}

TEST_CASE("what the camera sees of things that glow is told apart", "[render]") {
    for (const char* const way : {"", "global_settings { integrator { path_traced bounces 2 } }"}) {
        const std::string glowing = R"(#version 3.7; global_settings { assumed_gamma 1 }
            #default { finish { ambient 0 } }
            camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
            background { rgb <0, 0, 0.5> }
            box { <-2, -1.5, 0>, <0, 0, 1> pigment { rgb 0.5 } finish { emission 1 diffuse 0.5 } }
            box { <0, -1.5, 0>, <2, 0, 1> pigment { rgb 0 } finish { reflection 1 } }
            sphere { <1, 0, -8>, 2 pigment { rgb 1 } finish { emission 3 diffuse 0 } } )";
        const Shot shot = shot_of(glowing + way);
        Aovs aovs;
        aovs.squares = true;
        const RenderState state = made(shot, aovs, 1);
        const auto glow = [&](int x, int y) {
            const auto sums = state.film.extra(state.film.index(x, y));
            return Rgb(sums[0].value(), sums[1].value(), sums[2].value());
        };
        const auto square = [&](int x, int y) {
            return state.film.extra(state.film.index(x, y))[aovs.first_square()].value();
        };
        CHECK(glow(4, 13) == Rgb(0.5));          // a surface, its own light only
        CHECK(glow(18, 12) == Rgb(0));           // a mirror that shows the lamp
        CHECK(square(18, 12) > 8);               // its light is what it reflects
        CHECK(glow(12, 2) == Rgb(0, 0, 0.5));    // the sky
        CHECK(square(12, 2) == Approx(0).margin(1e-12));
    }
}

TEST_CASE("a luminous sky is a lamp like others", "[render]") {
    for (const char* const way : {"", "global_settings { integrator { path_traced bounces 2 } }",
                                  "sphere { <0, 1, 2>, 1 hollow pigment { rgbt 1 } interior { "
                                  "media { scattering { 1, 0.5 } } } }"}) {
        INFO(way);
        std::string clear = room;  // fog would hide the sky
        clear.erase(clear.find("fog"), clear.find("plane") - clear.find("fog"));
        const Shot shot = shot_of(clear + lamps[0] + R"(
            sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb <1, 2, 3>] } } luminaire })" +
                                  way);
        REQUIRE(shot.world->provenance.light_statements.size() == 2);
        Aovs aovs;
        aovs.lights = true;
        const RenderState state = made(shot, aovs);
        Rgb of_sky(0);
        for (std::size_t i = 0; i < state.film.pixels().size(); ++i) {
            const Rgb seen = state.film.pixels()[i].mean();
            of_sky += light(state, aovs, i, 1);
            for (int c = 0; c < 3; ++c)
                CHECK(light(state, aovs, i, 0)[c] + light(state, aovs, i, 1)[c] ==
                      Approx(seen[c]).margin(1e-9));
        }
        CHECK(of_sky.b > 20);
    }
}

TEST_CASE("light that surfaces reflect is counted for the statement that it came from",
          "[render]") {
    for (const char* const indirect :
         {"radiosity { recursion_limit 2 }", "integrator { path_traced bounces 3 }"}) {
        INFO(indirect);
        const Shot shot =
            shot_of(room + lamps[0] + lamps[1] + lamps[2] + "global_settings { " + indirect + " }");
        Aovs aovs;
        aovs.lights = true;
        const RenderState state = made(shot, aovs);
        for (std::size_t i = 0; i < state.film.pixels().size(); ++i) {
            Rgb sum(0);
            for (std::size_t k = 0; k < 3; ++k) sum += light(state, aovs, i, k);
            const Rgb seen = state.film.pixels()[i].mean();
            for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(seen[c]).margin(1e-9));
        }
    }
}

TEST_CASE("a statement's light is the picture that it makes alone", "[render]") {
    const Shot both = shot_of(room + lamps[0] + lamps[1]);
    Aovs aovs;
    aovs.lights = true;
    const RenderState state = made(both, aovs);
    for (std::size_t k = 0; k < 2; ++k) {
        const RenderState alone = made(shot_of(room + lamps[k]), {});
        for (std::size_t i = 0; i < state.film.pixels().size(); ++i) {
            const Rgb part = light(state, aovs, i, k), whole = alone.film.pixels()[i].mean();
            for (int c = 0; c < 3; ++c) CHECK(part[c] == Approx(whole[c]).margin(1e-9));
        }
    }
}

TEST_CASE("gathering changes nothing in the picture", "[render]") {
    const Shot shot = shot_of(room + lamps[0] + lamps[2]);
    Aovs aovs;
    aovs.lights = aovs.surface = true;
    const RenderState more = made(shot, aovs), less = made(shot, {});
    CHECK(std::ranges::equal(more.film.pixels(), less.film.pixels()));
}

TEST_CASE("depth and object are those of the pixel's middle; albedo is of all samples",
          "[render]") {
    const std::string script =
        R"(#version 3.7; camera { orthographic location -5*z right 4*x up 3*y }
box { <-9, -9, 0>, <0.01, 9, 1> pigment { rgb <1, 0, 0.5> } })";
    CompileOptions options;
    options.remembers_objects = true;
    Diagnostics diagnostics;
    const Shot shot(compile(scene_of(script), options, diagnostics));
    Aovs aovs;
    aovs.surface = true;
    const RenderState state = made(shot, aovs, 16);
    const auto sum = [&](int x, std::size_t which) {
        return state.film.extra(state.film.index(x, 9))[which].value();
    };
    CHECK(sum(3, aovs.depth()) == Approx(5));
    CHECK(sum(3, aovs.object()) == 1);
    CHECK(sum(3, aovs.albedo()) == Approx(16));
    CHECK(sum(3, aovs.albedo() + 2) == Approx(8));
    CHECK(sum(3, aovs.normal() + 2) == Approx(-16));
    CHECK(sum(20, aovs.depth()) == 0);
    CHECK(sum(20, aovs.object()) == 0);
    CHECK(sum(20, aovs.albedo()) == 0);
    // The edge covers a part of this pixel, but not its centre.
    CHECK(sum(12, aovs.object()) == 0);
    CHECK(sum(12, aovs.albedo()) > 0);
    CHECK(sum(12, aovs.albedo()) < 8);
}

TEST_CASE("alpha follows POV-Ray's rules", "[render]") {
    struct Case {
        const char* script;
        double opaque;
    };
    const std::string camera = "camera { location -5*z look_at 0 angle 1 }\n";
    const Case cases[] = {
        {"", 0},
        {"background { rgb 0.5 }", 1},
        {"background { rgbt <1, 1, 1, 0.25> }", 0.75},
        {"sky_sphere { pigment { rgb 1 } }", 1},
        {"sky_sphere { pigment { rgbt <1, 1, 1, 0.5> } }", 0.5},
        {"plane { -z, 0 pigment { rgbt <.8, .5, .2, .4> } finish { ambient 0 } }", 0.6},
        {"plane { -z, 0 pigment { rgbf <.8, .5, .2, .4> } finish { ambient 0 } }", 0.77804},
        {"plane { -z, 0 pigment { rgb 1 } finish { ambient 0 reflection 1 } }", 1},
        {"#version 3.6; background { rgb 0.5 }", 0},
    };
    for (const Case& each : cases) {
        CAPTURE(each.script);
        Aovs aovs;
        aovs.alpha = true;
        const RenderState state = made(shot_of("#version 3.7;" + camera + each.script), aovs, 1);
        CHECK(1 - state.film.extra(200)[0].value() == Approx(each.opaque).margin(1e-4));
    }
}

}  // namespace candelabra
