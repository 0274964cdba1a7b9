// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/show_preview.h"

#include "preview/renderer.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a preview gets the world, the names of its lamps, and the gamma of the scene") {
    Shell shell;
    Options options;
    options.scene = shell.path("a.pov");
    options.verbose = false;
    Console console;
    std::string said;
    console.err = console.out = [&](std::string_view text) { said += text; };
    std::vector<std::string> lights;
    int calls = 0;
    double gamma = 0;
    console.preview = [&](const ReadyScene& ready) {
        ++calls;
        lights = ready.lights;
        gamma = ready.format.gamma;
    };
    const auto run = [&](std::string_view scene) {
        shell.write("a.pov", scene);
        Diagnostics diagnostics;
        SceneSteps steps(options, console, diagnostics);
        const int opened = steps.open();
        return opened == exit_status::done ? show_preview(steps) : opened;
    };
    CHECK(run("#version 3.7; global_settings { assumed_gamma 2.2 }\n"
              "#declare Lamp = sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }\n"
              "object { Lamp } plane { y, -2 }\n") == exit_status::done);
    CHECK(calls == 1);
    CHECK(lights == std::vector<std::string>{"Lamp"});
    CHECK(gamma == 2.2);
    CHECK_FALSE(has(said, "error"));
    CHECK(run("#version 3.7; shpere { 0, 1 }") == exit_status::scene);
    CHECK(calls == 1);
    CHECK(has(said, "`sphere`"));
}

}  // namespace candelabra
