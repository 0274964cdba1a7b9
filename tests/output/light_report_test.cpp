// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_report.h"

#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string ten_lights = R"(#version 3.7;
camera { location <0, 3, -5> look_at 0 }
plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.8 } }
#declare Lamp = sphere { 0, 0.1 pigment { rgb 1 } finish { emission 3 } }
#for (I, 1, 9)
    object { Lamp translate <I - 5, 1, 0> }
#end
light_source { <0, 5, 0>, 0.1 }
)";

Rendering rendered(const Shot& shot, int threads) {
    RenderSettings settings;
    settings.width = settings.height = 24;
    settings.threads = threads;
    RenderHooks hooks;
    hooks.counts_lights = true;
    return render(shot, settings, hooks);
}

}  // namespace

TEST_CASE("the report of light tells how many things glow and are no luminaires", "[output]") {
    const auto report = [](const std::string& settings, const std::string& finish) {
        const std::string scene = "#version 3.7; camera { location -5*z } " + settings +
                                  "#for (I, 1, 3) sphere { I*x, 0.1 pigment { rgb 1 } finish { " +
                                  finish + " } } #end light_source { -9*z, 1 }";
        const Shot shot = shot_of(scene);
        SourceStore sources;
        sources.add("scene.pov", scene);
        return light_report(*shot.world, rendered(shot, 1).rays, sources);
    };
    const std::string line = "                            3  that glow, but light nothing\n";
    CHECK(report("", "emission 0.3").find("light nothing") == std::string::npos);
    CHECK(report("", "emission 0.3 no_luminaire").ends_with(line));
    CHECK(report("global_settings { luminaires none }", "emission 0.3").ends_with(line));
    CHECK(report("global_settings { luminaires above 0.5 }", "emission 0.3").ends_with(line));
}

TEST_CASE("the report of light has a line for each statement that makes lights", "[output]") {
    const Shot shot = shot_of(ten_lights);
    REQUIRE(shot.world->provenance.light_statements.size() == 2);
    SourceStore sources;
    sources.add("scene.pov", ten_lights);
    const Rendering made = rendered(shot, 1);
    const std::string text = light_report(*shot.world, made.rays, sources);
    INFO(text);
    CHECK(text.find("         9  scene.pov:6: object { Lamp translate <I - 5, 1, 0> }") !=
          std::string::npos);
    CHECK(text.find("         1  scene.pov:8: light_source") != std::string::npos);
    std::uint64_t rays = 0;
    for (const LightCount& each : made.rays.lights) rays += each.rays;
    CHECK(rays == made.rays.shadow);
    CHECK(light_report(*shot.world, rendered(shot, 3).rays, sources) == text);
    const LightShares shares = light_shares(*shot.world, made.rays);
    REQUIRE(shares.rows.size() == 2);
    const LightRow& first = shares.rows[0];
    const LightRow& second = shares.rows[1];
    CHECK(first.light >= second.light);
    CHECK(first.light + second.light == Approx(1));
    CHECK(first.rays + second.rays + shares.missed == Approx(1));
    CHECK(first.lights + second.lights == 10);
    CHECK(first.statement != second.statement);
}

TEST_CASE("the report names lamps from which no light comes", "[output]") {
    const std::string hidden = "sphere { <0, -2, 0>, 0.1 pigment { rgb 1 } finish { emission 3 } }";
    for (const bool any : {false, true}) {
        const std::string script = ten_lights + (any ? hidden : "");
        const Shot shot = shot_of(script);
        SourceStore sources;
        sources.add("scene.pov", script);
        const std::string text = light_report(*shot.world, rendered(shot, 1).rays, sources);
        INFO(text);
        CHECK((text.find("no light came from scene.pov:9: sphere { <0, -2") != std::string::npos) ==
              any);
    }
}

TEST_CASE("lights are counted only when that is asked for", "[output]") {
    RenderSettings settings;
    settings.width = settings.height = 4;
    CHECK(render(shot_of(ten_lights), settings).rays.lights.empty());
}

}  // namespace candelabra
