// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/chosen_light.h"

#include "support/lit.h"
#include "support/means.h"
#include "support/scripts.h"
#include "support/twins.h"
#include "transport/integrator.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

TEST_CASE("a sphere above a floor gives the irradiance of its cone", "[render]") {
    // A sphere of radius r straight above at distance d: E = pi L (r/d)^2; albedo 0.8.
    const Shot shot = shot_of(R"(
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
        sphere { <0, 5, 0>, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 10 } no_image }
    )");
    CHECK(mean_light(shot, 1, 20000) == Approx(0.8 * 10 * 0.04).epsilon(0.01));
    CHECK(mean_light(shot, 4, 5000) == Approx(0.8 * 10 * 0.04).epsilon(0.01));
}

TEST_CASE("luminaires that hide each other are counted once, whoever is chosen", "[render]") {
    // A faint sphere hides a bright one; above both is a clear one, which adds its light.
    const std::string scene = R"(
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
        sphere { <0, 5, 0>, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 10 } no_image }
        sphere { <0, 8, 0>, 1.2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 90 } no_image }
    )";
    const std::string clear = R"(
        sphere { <0, 4.3, 0>, 1.6 pigment { rgbt <1, 1, 1, 0.5> }
                 finish { ambient 0 diffuse 0 emission 4 } no_image }
    )";
    const auto mean = [](const std::string& text, const LightSampler& sampler) {
        return mean_light(Shot(world_of(scene_of(text), sampler)), 1, 40000);
    };
    LightOctree alone;
    alone.alone = true;
    LightBvh pair;
    pair.mis = true;
    for (const std::string& text : {scene, scene + clear}) {
        const double exact = mean(text, EveryLight{});
        CHECK(exact > 0);
        for (const double share : {0.5, 0.7, 0.9}) {
            LightOctree octree;
            octree.outlook = share;
            CHECK(mean(text, octree) == Approx(exact).epsilon(0.02));
        }
        CHECK(mean(text, alone) == Approx(exact).epsilon(0.02));
        CHECK(mean(text, pair) == Approx(exact).epsilon(0.02));
    }
    CHECK(mean(scene, LightOctree{}) == Approx(0.8 * 10 * 0.04).epsilon(0.02));
}

TEST_CASE("a luminaire that reflects is lit by the others and not by itself", "[render]") {
    const Shot shot = shot_of(R"(
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 emission 3 } }
        sphere { <0, 5, 0>, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 10 } no_image }
    )");
    CHECK(mean_light(shot, 1, 20000) == Approx(0.8 * 10 * 0.04).epsilon(0.02));
}

TEST_CASE("shadow rays go where there is noise, and change no mean", "[render][claim-30]") {
    // The lamps are near the right end of the floor, and half of them hide behind a board.
    const Shot shot = shot_of(R"(
        #version 3.7;
        camera { location <0, 3, -25> look_at 0 }
        box { <-20, -1, -9>, <20, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
        box { <13, 1, -9>, <14, 1.1, 9> pigment { rgb 0.8 } }
        #for (I, 0, 60)
            sphere { <15 + mod(I, 8)/2, 2, I/8 - 4>, 0.1 pigment { rgb 1 } finish { emission 9 } }
        #end
    )");
    const Lit dim = lit_at(shot, -18, {4}, 2000), bright = lit_at(shot, 13.5, {4}, 2000);
    CHECK(dim.rays <= 4);
    CHECK(bright.noise > 20 * dim.noise);
    const ShadowRays fitted(4, bright.noise / 4);
    const Lit fewer = lit_at(shot, -18, fitted, 8000), more = lit_at(shot, 13.5, fitted, 500);
    CHECK(fewer.rays <= 1);
    CHECK(more.rays > 1.5 * bright.rays);
    CHECK(fewer.mean == Approx(dim.mean).epsilon(0.02));
    CHECK(more.mean == Approx(bright.mean).epsilon(0.02));
}

TEST_CASE(
    "luminaires that give little beside other light are asked seldom, and give it all the same",
    "[render]") {
    const auto lit = [](const std::string& lights) {
        return lit_at(
            shot_of("box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 "
                    "diffuse 1 } }" +
                    lights),
            0, 1, 40000);
    };
    // E = pi L (r/d)^2
    const std::string dim =
                          "blob { threshold 0.5 sphere { <0, 5, 0>, 2, 2 } no_image pigment { rgb "
                          "1 } finish { ambient 0 diffuse 0 emission 0.05 } }",
                      lamp = "light_source { <3, 4, 0>, rgb 1 }";
    const Lit alone = lit(dim), beside = lit(dim + lamp), without = lit(lamp);
    REQUIRE(alone.mean < 0.02 * without.mean);
    CHECK(beside.mean - without.mean == Approx(alone.mean).epsilon(0.15));
    CHECK(alone.rays > 0.9);
    CHECK(beside.rays - without.rays < 0.1);
}

namespace {

struct Strategy {
    const char* name;
    LightSampler sampler;
};

/// All strategies but constant_alpha, whose noise is great.
std::vector<Strategy> strategies() {
    LightOctree alone, paper;
    alone.alone = true;
    paper.paper = true;
    LightBvh pair;
    pair.mis = true;
    return {{"every_light", EveryLight{}},
            {"linear_alpha", LinearAlpha{}},
            {"light_octree", LightOctree{}},
            {"alone", alone},
            {"paper", paper},
            {"light_bvh", LightBvh{}},
            {"mis", pair}};
}

double mean_with(const std::string& text, const LightSampler& sampler, int count) {
    return mean_light(Shot(world_of(scene_of("#version 3.7; " + text), sampler)), 1, count);
}

const std::string white_floor =
    "box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 1 } finish { ambient 0 diffuse 1 } } ";

}  // namespace

TEST_CASE("a lamp lights on the side on which it glows, whoever chooses it", "[render]") {
    // Each lamp is above the floor, or around it. With the same glow on both sides it gives `both`;
    // the floor gets all of this from one side, and nothing from the other.
    const std::string glow = "{ pigment { rgb 1 } finish { diffuse 0 emission 5 } } ",
                      dark = "{ pigment { rgb 0 } finish { diffuse 0 } } ";
    for (const char* const lamp :
         {"disc { 2*y, y, 1", "disc { 2*y, -y, 1, 0.3",
          "polygon { 5, <-1, 2, -1>, <1, 2, -1>, <1, 2, 1>, <-1, 2, 1>, <-1, 2, -1>",
          "triangle { <-1, 2, -1>, <1, 2, -1>, <0, 2, 1>",
          "mesh { triangle { <-1, 2, -1>, <1, 2, -1>, <0, 2, 1> }",
          "bicubic_patch { type 1 u_steps 2 v_steps 2 "
          "<-1,2,-1> <-.3,2,-1> <.3,2,-1> <1,2,-1> <-1,2,-.3> <-.3,2,-.3> <.3,2,-.3> <1,2,-.3> "
          "<-1,2,.3> <-.3,2,.3> <.3,2,.3> <1,2,.3> <-1,2,1> <-.3,2,1> <.3,2,1> <1,2,1>",
          "sphere { 2*y, 1 clipped_by { plane { -y, -2 } }", "sphere { 0, 30",
          "box { -30, 30 rotate 20*y", "difference { box { -30, 30 } box { -29, 29 }",
          "cylinder { y, 2*y, 1 open clipped_by { plane { z, 0 } }"}) {
        const std::string shape = white_floor + lamp + " no_image";
        const double both = mean_with(shape + " texture " + glow + "}", EveryLight{}, 4000);
        REQUIRE(both > 0.05);
        for (const Strategy& strategy : strategies()) {
            CAPTURE(lamp, strategy.name);
            const double outer = mean_with(
                             shape + " texture " + glow + "interior_texture " + dark + "}",
                             strategy.sampler, 6000),
                         inner = mean_with(
                             shape + " texture " + dark + "interior_texture " + glow + "}",
                             strategy.sampler, 6000);
            CHECK(std::min(outer, inner) == 0);
            CHECK(std::max(outer, inner) == Approx(both).epsilon(0.05));
        }
    }
}

TEST_CASE("of lamps in one place the one that is seen lights, whoever chooses it", "[render]") {
    const auto ball = [](const std::string& size, const std::string& emission) {
        return "sphere { 5*y, " + size + " pigment { rgb 1 } finish { diffuse 0 emission " +
               emission + " } } ";
    };
    struct Case {
        std::string lamps;
        double expected;
    };
    // E / pi = L (r / d)^2 for a ball.
    for (const Case& each :
         {Case{ball("1", "3") + ball("1", "3"), 3.0 / 25},
          Case{ball("1", "3") + ball("1", "15"), 3.0 / 25},
          Case{ball("1 - 1.4e-5", "30") + ball("1", "3"), 3.0 / 25},
          Case{ball("1 - 1e-8", "30") + ball("1", "3"), 3.0 / 25},
          Case{ball("1", "30") + ball("1 + 2e-7", "3"), 3.0 / 25},
          Case{"box { <-1, 4, -1>, <1, 5, 1> pigment { rgb 1 } finish { diffuse 0 emission 3 } } "
               "plane { y, 4 - 1e-7 pigment { rgb 1 } }",
               0},
          Case{"disc { 4*y, y, 1 pigment { rgb 1 } finish { diffuse 0 emission 3 } } "
               "box { <-5, 4 - 1e-7, -5>, <5, 5, 5> pigment { rgb 1 } }",
               0}})
        for (const Strategy& strategy : strategies()) {
            CAPTURE(each.lamps, strategy.name);
            CHECK(mean_with(white_floor + each.lamps, strategy.sampler, 8000) ==
                  Approx(each.expected).epsilon(0.1));
        }
}

TEST_CASE("a far large lamp and near small ones keep their light at any distance", "[render]") {
    // A sun of the same apparent size at every distance, and a ring of lamps.
    const auto scene = [](double distance, int lamps, const std::string& camera) {
        const std::string d = std::to_string(distance);
        return "#declare D = pow(10, " + d + "); #declare N = " + std::to_string(lamps) + "; " +
               camera +
               "box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } } "
               "sphere { <0, D, 0>, 0.2*D pigment { rgb 1 } finish { emission 10 diffuse 0 } } "
               "#for (I, 0, N - 1) sphere { <sin(2*pi*I/N)*2, .5, cos(2*pi*I/N)*2>, .02 "
               "pigment { rgb 1 } finish { emission 4100/N diffuse 0 } } #end ";
    };
    const std::string eye = "camera { location <0, 3, -6> look_at 0 } ",
                      parallel =
                          "camera { orthographic location <0, 3, -6> look_at 0 "
                          "right 8*x up 6*y } ";
    for (const int lamps : {41, 300})
        for (const std::string& camera : {eye, parallel}) {
            const double expected = mean_with(scene(3, lamps, camera), LinearAlpha{}, 20000);
            for (const double distance : {3.0, 5.0, 6.0, 7.0, 9.0, 15.0, 37.5})
                for (const Strategy& strategy : strategies()) {
                    if (std::holds_alternative<EveryLight>(strategy.sampler)) continue;
                    CAPTURE(lamps, camera, distance, strategy.name);
                    CHECK(mean_with(scene(distance, lamps, camera), strategy.sampler, 6000) ==
                          Approx(expected).epsilon(0.1));
                }
        }
}

TEST_CASE("light stays finite where hardly anything of a path is left", "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; camera { location 0.5*y look_at <9, 0, 0> } "
        "global_settings { integrator { path_traced bounces 0 } } "
        "plane { y, 0 pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } } "
        "light_source { 1e6*y, 1 } sky_sphere { pigment { rgb 0.3 } luminaire } "
        "media { scattering { 1, rgb 0.03 } }");
    Integrator integrator(shot, {});
    for (const double away : {1e3, 1e4, 2e4, 2.2e4, 2.3e4, 2.4e4, 2.45e4, 1e5})
        for (std::uint32_t sample = 0; sample < 20; ++sample) {
            const Rgb seen = integrator.radiance({Vec3(0, 0.5, 0), unit(Vec3(away, -0.5, 0))},
                                                 {0, sample, 0, 0});
            CAPTURE(away);
            CHECK(std::isfinite(seen.r));
        }
}

namespace {

/// Forty sources that fade, some of them spots, beside twenty lamps, some of them hidden.
const std::string both_kinds = R"(
    #version 3.7;
    camera { location <0, 3, -9> look_at 0 }
    box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 $ } }
    box { <0.5, 0.6, -9>, <2, 0.7, 9> pigment { rgb 0.5 } }
    box { <-4, 0.9, -9>, <-1, 1, 9> pigment { rgbt 0.5 } }
    #declare R = seed(4);
    #macro Place() <8*rand(R) - 4, 0.4 + 2*rand(R), 8*rand(R) - 4> #end
    #for (I, 1, 40)
        light_source { Place(), rgb 0.3*rand(R) fade_distance 0.5 fade_power 2
            #if (mod(I, 3) = 0) spotlight point_at Place() - 3*y radius 20 falloff 50 #end }
    #end
    #for (I, 1, 20)
        sphere { Place(), 0.05 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 20*rand(R) } }
    #end
)";

std::string with_finish(std::string script, const std::string& words) {
    return script.replace(script.find('$'), 1, words);
}

}  // namespace

TEST_CASE("one draw among sources and luminaires gives the light of all", "[render]") {
    LightOctree alone;
    alone.alone = true;
    const std::string sky = "sky_sphere { pigment { rgb 0.1 } luminaire } ";
    for (const std::string& more : {std::string(), sky})
        for (const std::string finish : {"", "specular 0.5 roughness 0.05"}) {
            const std::string script = with_finish(both_kinds, finish) + more;
            const Shot every(world_of(scene_of(script), EveryLight{}));
            REQUIRE(!every.joined);
            for (const LightOctree& sampler : {LightOctree{}, alone}) {
                const Shot shot(world_of(scene_of(script), sampler));
                REQUIRE(shot.joined);
                CHECK(shot.lamp(0) == Lamp::luminaire(0));
                CHECK(shot.lamp(20) == Lamp::source(shot.joined->lights[0]));
                for (const double x : {-3.0, -0.5, 1.2, 3.0}) {
                    CAPTURE(more, finish, sampler.alone, x);
                    CHECK(lit_at(shot, x, 4, 20000).mean ==
                          Approx(lit_at(every, x, 4, 4000).mean).epsilon(0.02));
                }
            }
        }
}

TEST_CASE("one draw leaves out the kind that does not light an object", "[render]") {
    // Nothing of a group without global lights gets light of sources that are in none.
    const auto scene = [](const std::string& group) { return with_finish(both_kinds, "") + group; };
    const std::string patch =
        "box { <-1, 0.1, -1>, <1, 0.2, 1> pigment { rgb 1 } finish { ambient 0 diffuse 1 } } ";
    const std::string apart = "light_group { " + patch + " global_lights off } ";
    const auto light = [&](const std::string& group, const LightSampler& sampler) {
        return lit_at(Shot(world_of(scene_of(scene(group)), sampler)), -0.5, 4, 20000).mean;
    };
    const double lamps = light(apart, EveryLight{}), all = light(patch, EveryLight{});
    CHECK(lamps < 0.9 * all);
    CHECK(light(apart, LightOctree{}) == Approx(lamps).epsilon(0.02));
    CHECK(light(patch, LightOctree{}) == Approx(all).epsilon(0.02));
}

TEST_CASE("one draw is made only where all that is chosen may count", "[world]") {
    const auto joins = [](const std::string& more) {
        return shot_of(with_finish(both_kinds, "") + more).joined != nullptr;
    };
    CHECK(joins(""));
    CHECK(joins("global_settings { integrator { path_traced } } "));
    CHECK_FALSE(joins("global_settings { radiosity { } } "));
    CHECK_FALSE(joins("global_settings { light_sampler { light_bvh } } "));
    CHECK_FALSE(joins("global_settings { light_sampler { light_octree { paper } } } "));
}

TEST_CASE("paths find the light of all kinds by one draw", "[transport]") {
    const Ray down{Vec3(-0.5, 0.5, 0), Vec3(0, -1, 0)};
    for (const std::string integrator : {"", "integrator { path_traced { bounces 2 } }"}) {
        const auto seen = [&](const std::string& sampler, std::uint32_t count) {
            return mean_seen(with_finish(both_kinds, "") + "global_settings { " + integrator +
                                 " light_sampler { " + sampler + " } } ",
                             down, count);
        };
        const Mean joined = seen("light_octree", 8000), every = seen("every_light", 800);
        CAPTURE(integrator, joined.value, every.value);
        CHECK(agree(joined, every, 0.005));
    }
}

TEST_CASE("lamps of instances light a floor as those that are taken apart", "[render]") {
    const std::string lamps = R"(
        #declare Stand = union {
            #for (I, 0, 8) sphere { <0.1*I - 0.4, 0.05*I, 0.1>, 0.02 + 0.01*mod(I, 3) } #end
            box { <-0.2, 0.5, -0.1>, <0, 0.55, 0.2> rotate 30*y }
            triangle { <0, 0.7, 0>, <0.3, 0.7, 0>, <0, 0.8, 0.3> }
            cylinder { <0.2, 0, 0>, <0.2, 0.4, 0>, 0.05 pigment { rgb 0.5 } finish { emission 0 } }
            pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 3 }
        }
        #for (I, 0, 15)
            object { Stand rotate 50*I*y scale <1, 1, pow(-1, I)> scale 0.4 + 0.1*mod(I, 5)
                     translate <mod(I, 4) - 1.5, 0.3 + 0.1*I, floor(I/4) - 1.5> }
        #end
        sphere { <0, 6, 0>, 0.5 pigment { rgb 1 } finish { emission 2 } no_image }
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
    )";
    LightBvh pair;
    pair.mis = true;
    LightOctree alone;
    alone.alone = true;
    const auto lit = [&](const InstanceLimits& limits, const LightSampler& sampler, double x) {
        CompileOptions options;
        options.light_sampler = sampler;
        options.instances = limits;
        Diagnostics diagnostics;
        const SharedWorld world = compile(scene_of(lamps), options, diagnostics);
        CHECK(world->geometry.instances.size() == (limits.least_parts == 2 ? 16 : 0));
        // Each sample asks every light once, so few do for that strategy.
        const int count = std::holds_alternative<EveryLight>(sampler) ? 1000 : 20000;
        return lit_at(Shot(world), x, {1}, count).mean;
    };
    for (const double x : {0.35, 2.5, 8.0}) {
        const double exact = lit({}, EveryLight{}, x);
        CHECK(lit({2, 100, 2}, EveryLight{}, x) == Approx(exact).epsilon(0.005));
        for (const LightSampler& sampler : {LightSampler(LightOctree{}), LightSampler(alone),
                                            LightSampler(pair), LightSampler(LinearAlpha{})})
            CHECK(lit({2, 100, 2}, sampler, x) == Approx(exact).epsilon(0.02));
    }
}

}  // namespace candelabra
