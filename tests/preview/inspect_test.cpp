// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/inspect.h"

#include "render/render.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string inspected_scene = R"(#version 3.7;
camera { location -5*z look_at 0 angle 50 }
sphere { <-1, 0, 0>, 0.8 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 1 } }
plane { z, 3 pigment { rgb 1 } finish { ambient 0.5 diffuse 0 } }
light_source { <-1, 0, -5>, 3 }
light_source { <-1, 0, -5>, 1 }
)";

/// A scene with a picture to inspect.
struct Inspected {
    Shot shot = compiled();
    SourceStore sources;
    RenderSettings settings;
    RenderState state;
    LightLedger rays;

    Inspected() {
        sources.add("scene.pov", inspected_scene);
        settings.width = 32;
        settings.height = 24;
        settings.samples = 2;
        state = begin_picture(settings);
        advance(plan_of(shot, settings), state, rays, {});
    }
    static Shot compiled() {
        CompileOptions options;
        options.remembers_objects = true;
        Diagnostics diagnostics;
        return Shot(compile(scene_of(inspected_scene), options, diagnostics));
    }
    RenderedPicture picture() const { return {shot, sources, settings, state.film, rays}; }
};

}  // namespace

TEST_CASE("a pixel tells its colour, object and texture, and who lights it", "[preview]") {
    const Inspected look;
    const std::string ball = what_is_under(look.picture(), 10, 12);
    INFO(ball);
    const auto says = [&](std::string_view part) { return ball.find(part) != ball.npos; };
    CHECK(ball.starts_with("<10, 12>: rgb <"));
    CHECK(says("\nobject 1: scene.pov:3: sphere { <-1, 0, 0>"));
    CHECK(says("normal <"));
    CHECK(says("pigment { rgb <1, 0.5, 0>"));
    CHECK(says("\n  75 %  scene.pov:5: light_source"));
    CHECK(says("\n  25 %  scene.pov:6: light_source"));
    CHECK(ball.find("scene.pov:5") < ball.find("scene.pov:6"));
    const std::string wall = what_is_under(look.picture(), 30, 2);
    CHECK(wall.find("100 %  sky, ambient light and fog") != wall.npos);
    CHECK(what_is_under(look.picture(), 32, 0).empty());
    CHECK(what_is_under(look.picture(), -1, 0).empty());
}

TEST_CASE("layers can be looked at, each in a way that a screen shows", "[preview]") {
    const Inspected look;
    const RenderedPicture shown = look.picture();
    const auto colour = [&](std::string_view name, int x, int y) {
        const auto image = view(shown, name);
        REQUIRE(image);
        CHECK(image->width == 32);
        return image->at(x, y);
    };
    for (const std::string_view name : views()) {
        CAPTURE(name);
        const auto image = view(shown, name);
        REQUIRE(image);
        for (const Rgb& pixel : image->pixels) CHECK(std::isfinite(pixel.r));
    }
    CHECK(colour("albedo", 10, 12).g == Approx(0.5));
    CHECK(colour("normal", 30, 2).b == Approx(0));  // towards the camera
    CHECK(colour("depth", 10, 12).r > colour("depth", 30, 2).r);
    CHECK(colour("object", 10, 12) != colour("object", 30, 2));
    CHECK(colour("samples", 0, 0).r == 1);
    CHECK_FALSE(view(shown, "nothing like it"));
    const auto small = view(shown, "albedo", 4);
    REQUIRE(small);
    CHECK(small->width == 8);
    CHECK(small->height == 6);
    CHECK(small->at(2, 3).g == Approx(0.5));
    CHECK(view(shown, "samples", 5)->width == 7);
    CHECK(is_still("albedo"));
    CHECK_FALSE(is_still("samples"));
    CHECK_FALSE(is_still("picture"));
}

}  // namespace candelabra
