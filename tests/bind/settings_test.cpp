// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/settings.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("global settings add up", "[bind]") {
    const Script done =
        run("#version 3.7; global_settings { max_trace_level 7 ambient_light rgb 0.5 } "
            "global_settings { adc_bailout 0.1 assumed_gamma 1 }");
    REQUIRE(done.text.empty());
    CHECK(done.scene.settings.max_trace_level == 7);
    CHECK(done.scene.settings.ambient_light == Rgb(0.5));
    CHECK(done.scene.settings.adc_bailout == 0.1);
}

TEST_CASE("colours by srgb are in the space of the assumed_gamma before them", "[bind]") {
    // 0.5 is decoded to 0.21404, and that to the power of 1 / 2.2 is 0.49621.
    const Script done =
        run("#version 3.7; global_settings { assumed_gamma 2.2 ambient_light srgb 0.5 }");
    CHECK(done.scene.settings.ambient_light.r == Approx(0.49621).epsilon(1e-4));
}

TEST_CASE("photometry states a unit of length and the luminance of white", "[bind]") {
    const auto units = [](const std::string& settings) {
        const Script done = run("#version 3.7; global_settings { " + settings + " }");
        INFO(done.text);
        REQUIRE(done.text.empty());
        return done.scene.settings.light_units();
    };
    CHECK(units("") == LightUnits{0.01, 200});
    CHECK(units("mm_per_unit 1000") == LightUnits{1, 200});
    CHECK(units("photometry { unit 0.5 white 80 } mm_per_unit 3") == LightUnits{0.5, 80});
    const Script late =
        run("#version 3.7; #declare L = lumen(800); global_settings { photometry { unit 1 } }");
    CHECK(late.text.find("have been converted by other units before") != std::string::npos);
    CHECK(run("#version 3.7; #declare L = nit(1); global_settings { max_trace_level 3 }")
              .text.empty());
    CHECK_FALSE(run("#version 3.7; global_settings { photometry { unit 0 } }").text.empty());
    CHECK(dump(run("#version 3.7; global_settings { photometry { unit 1 } }").scene)
              .find("photometry { unit 1 }") != std::string::npos);
}

TEST_CASE("each light sampler can be chosen", "[bind]") {
    for (std::size_t kind = 0; kind < Kinds<LightSampler>::count; ++kind) {
        const std::string name(Kinds<LightSampler>::infos[kind]->name);
        CHECK(run("#version 3.7; global_settings { light_sampler { " + name + " } }")
                  .scene.settings.light_sampler.index() == kind);
        CHECK(run("#version 3.7; global_settings { light_sampler { " + name + " { } } }")
                  .scene.settings.light_sampler.index() == kind);
    }
    for (const char* octree : {"light_octree { paper threshold 0.5 max_depth 3 }",
                               "light_octree paper threshold 0.5 max_depth 3"}) {
        const Script done =
            run(std::string("#version 3.7; global_settings { light_sampler { ") + octree + " } }");
        INFO(done.text);
        REQUIRE(done.text.empty());
        CHECK(std::get<LightOctree>(done.scene.settings.light_sampler).threshold == 0.5);
        CHECK(std::get<LightOctree>(done.scene.settings.light_sampler).max_depth == 3);
    }
}

TEST_CASE("each index can be chosen", "[bind]") {
    for (std::size_t kind = 0; kind < Kinds<RayIndex>::count; ++kind) {
        const std::string name(Kinds<RayIndex>::infos[kind]->name);
        CHECK(run("#version 3.7; global_settings { index { " + name + " } }")
                  .scene.settings.index.index() == kind);
    }
    const Script done =
        run("#version 3.7; global_settings { index { kd_tree { node_cost 2 } } light_sampler { "
            "light_bvh } }");
    REQUIRE(done.text.empty());
    CHECK(std::get<KdTree>(done.scene.settings.index).node_cost == 2);
    CHECK(std::holds_alternative<LightBvh>(done.scene.settings.light_sampler));
}

TEST_CASE("radiosity has all of POV-Ray's words", "[bind]") {
    const Script done = run(R"(#version 3.7; global_settings { radiosity {
        count 50, 900 error_bound 0.5 nearest_count 5, 2 low_error_factor 0.4 minimum_reuse 0.01
        maximum_reuse 0.1 pretrace_start 0.08 pretrace_end 0.01 recursion_limit 3 brightness 1.5
        gray_threshold 0.25 max_sample 2 adc_bailout 0.01 always_sample off normal on media on
        subsurface off } } sphere { 0, 1 no_radiosity })");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said.front().message ==
          "`count`, `error_bound`, `nearest_count`, `low_error_factor`, `minimum_reuse`, "
          "`maximum_reuse`, `pretrace_start`, `pretrace_end`, `adc_bailout`, `always_sample`, "
          "`subsurface` of `radiosity` have no effect: light is gathered without a cache");
    const Radiosity& found = done.scene.settings.radiosity;
    CHECK(found.on);
    CHECK(found.recursion_limit == 3);
    CHECK(found.gray_threshold == 0.25);
    CHECK(found.max_sample == 2);
    CHECK(found.normal);
    CHECK_FALSE(found.always_sample);
    CHECK(done.scene.objects.size() == 1);
    CHECK(complaint("global_settings { radiosity { recursion_limit 0 } }") != "nothing");
    CHECK(complaint("global_settings { radiosity { count 20 brightness 2 } }") ==
          "warning no-effect: `count` of `radiosity` has no effect: light is gathered without a "
          "cache");
    CHECK(complaint("global_settings { radiosity { brightness 2 normal on } }") == "nothing");
}

TEST_CASE("photons have all of POV-Ray's words", "[bind]") {
    const Script done = run(R"(#version 3.7; global_settings { photons {
        spacing 0.1 count 500 gather 10, 20 radius 0.1, 2, 0.2, 2 media 100, 2 jitter 0.4
        max_trace_level 7 adc_bailout 0.1 autostop 0 expand_thresholds 0.2, 40 } })");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said.front().message ==
          "`jitter`, `autostop`, `expand_thresholds` of `photons` have no effect: photons are shot "
          "anew again and again");
    const PhotonSettings& found = done.scene.settings.photons;
    CHECK(found.shoots());
    CHECK(found.count == 500);
    CHECK(found.gather_most == 20);
    CHECK(found.max_trace_level == 7);
    CHECK(run("#version 3.7; global_settings { photons { } }").text.empty());
}

TEST_CASE("what is said of photons is written where it was said", "[bind]") {
    const std::string text = dump(run(R"(#version 3.7;
        global_settings { photons { count 9 radius 0.2, 2 } }
        light_source { 9*y, rgb 1 photons { reflection off area_light } }
        sphere { 0, 1 photons { target refraction on collect off } })")
                                      .scene);
    for (const char* part :
         {"global_settings { photons { count 9 radius 0.2, 2 } }",
          "photons { reflection 0 area_light }", "photons { target 1 refraction 1 collect off }"})
        CHECK(text.find(part) != std::string::npos);
    CHECK(dump(run(text).scene) == text);
}

TEST_CASE("each integrator can be chosen", "[bind]") {
    for (std::size_t kind = 0; kind < Kinds<IntegratorSettings>::count; ++kind) {
        const std::string name(Kinds<IntegratorSettings>::infos[kind]->name);
        CHECK(run("#version 3.7; global_settings { integrator { " + name + " } }")
                  .scene.settings.integrator.index() == kind);
    }
    const Script done =
        run("#version 3.7; global_settings { integrator { path_traced { bounces 3 } } }");
    REQUIRE(done.text.empty());
    CHECK(std::get<PathTraced>(done.scene.settings.integrator).bounces == 3);
}

TEST_CASE("a background is one colour, the last one", "[bind]") {
    const Script done =
        run("#version 3.7; background { rgb 1 } background { color rgb <1, 2, 3> }");
    REQUIRE(done.text.empty());
    CHECK(done.scene.background.colour.rgb == Rgb(1, 2, 3));
}

TEST_CASE("wrong settings are told of once", "[bind]") {
    CHECK(complaint("global_settings { charset utf8 } #declare A = \"plain\";") == "nothing");
    CHECK(complaint("global_settings { charset utf8 } #declare A = \"\xC3\xA9\";") ==
          "warning no-effect: `charset` has no effect in this version");
    CHECK(complaint("global_settings { photons { count 100 gather 30, 20 } }") ==
          "warning no-effect: there are no photons: the second number of `gather` is below the "
          "first");
    CHECK(complaint("global_settings { photons { count 100 target } }") ==
          "error misplaced: `target` has no place in `photons`");
    CHECK(complaint("global_settings { radiosity { importance 1 } }") ==
          "warning no-effect: `importance` has no effect in this version");
    CHECK(complaint("global_settings { subsurface { samples 9, 9 radiosity on } }") ==
          "warning no-effect: `radiosity` has no effect in this version");
    CHECK(complaint("global_settings { foo 1 }") ==
          "error unknown-word: `global_settings` has no word `foo`");
    CHECK(complaint("global_settings { assumed_gamma 1 } global_settings { assumed_gamma 2 }") ==
          "warning duplicate: `assumed_gamma` has been given before; the first one counts");
    CHECK(complaint("global_settings { light_sampler { } }") ==
          "error missing: `light_sampler` needs the name of a strategy");
    CHECK(complaint("global_settings { light_sampler { light_otree } }") ==
          "error unknown-word: `light_sampler` has no word `light_otree`");
    CHECK(complaint("global_settings { light_sampler { every_light light_bvh } }") ==
          "error duplicate: `light_sampler` has one strategy, and this is a second");
    CHECK(complaint("global_settings { light_sampler { light_octree { threshold -1 } } }") ==
          "error out-of-range: `threshold` of `light_octree` must be above 0, but it is -1");
    CHECK(complaint("global_settings { index { } }") ==
          "error missing: `index` needs the name of a structure");
    CHECK(complaint("global_settings { index { kd_tree bounding_boxes } }") ==
          "error duplicate: `index` has one structure, and this is a second");
    CHECK(complaint("background { }") == "nothing");
}

TEST_CASE("assumed_gamma may be the curve of sRGB", "[bind]") {
    const Script done =
        run("#version 3.7; global_settings { assumed_gamma srgb max_trace_level 7 }");
    REQUIRE(done.text.empty());
    CHECK(done.scene.settings.assumed_gamma < 0);
    CHECK(done.scene.settings.max_trace_level == 7);
}

}  // namespace candelabra
