// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/idle_lights.h"

#include "output/layers.h"
#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A wall in the light of a bright source, a dim one, one behind it, and a faint lamp.
const std::string four_lights = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location -5*z }
plane { z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
light_source { -9*z, 0.5 }
light_source { <3, 0, -9>, 0.01 }
light_source { 9*z, 1 }
light_source { <-3, 0, -9>, 0.0001 }
)";

struct Made {
    Shot shot;
    RenderState state;
    FilmFiles files;
};

Made made_of(const std::string& scene, const FilmSettings& film = {}) {
    Made made{shot_of(scene), {}, {}};
    made.files.layers = {PictureLayer::lights};
    made.files.lights = {"one", "two", "three", "four"};
    made.files.film = film;
    RenderSettings settings;
    settings.width = settings.height = 16;
    RenderHooks hooks;
    hooks.aovs = made.files.aovs();
    made.state = begin_picture(settings, hooks.aovs.count(*made.shot.world));
    LightLedger rays;
    advance(plan_of(made.shot, settings), made.state, rays, hooks);
    return made;
}

}  // namespace

TEST_CASE("the change of the picture without a lamp is that of what a display shows", "[output]") {
    const Made made = made_of(four_lights);
    const std::vector<double> changes = changes_without(made.state.film, made.files);
    REQUIRE(changes.size() == 4);
    CHECK(changes[0] > 0.5);
    CHECK(changes[1] > 1.0 / 255);
    CHECK(changes[1] < 0.1);
    CHECK(changes[2] == 0);
    CHECK(changes[3] > 0);
    CHECK(changes[3] < 1.0 / 255);
    SourceStore sources;
    sources.add("scene.pov", four_lights);
    const std::string text = idle_lights_report(*made.shot.world, changes, sources);
    CHECK(text ==
          "could be off, since no pixel changes by 1/255 without it: scene.pov:6: light_source { "
          "9*z, 1 }\n"
          "could be off, since no pixel changes by 1/255 without it: scene.pov:7: light_source { "
          "<-3, 0, -9>, 0.0001 }\n");
}

TEST_CASE("a film shows the change of a lamp as it shows its light", "[output]") {
    FilmSettings film;
    film.on = true;
    film.exposure = 8;
    const Made bright = made_of(four_lights, film);
    CHECK(changes_without(bright.state.film, bright.files)[3] == 0);  // all is white
    film.exposure = -6;
    const Made dark = made_of(four_lights, film);
    CHECK(changes_without(dark.state.film, dark.files)[1] < 1.0 / 255);
    // An automatic exposure stays that of the whole picture when the brightest lamp is off.
    film.exposure = 0;
    film.auto_exposure = true;
    const Made steady = made_of(four_lights, film);
    const auto changes = changes_without(steady.state.film, steady.files);
    CHECK(changes[0] > 0.2);
    CHECK(changes[2] == 0);
}

}  // namespace candelabra
