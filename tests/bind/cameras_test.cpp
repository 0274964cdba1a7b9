// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/cameras.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

using std::numbers::pi;

TEST_CASE("a camera has its type and its words", "[bind]") {
    const Script done =
        run("#version 3.7; camera { orthographic location <1, 2, 3> look_at 0 angle 30 right 2*x "
            "translate x }");
    REQUIRE(done.text.empty());
    CHECK(std::holds_alternative<Orthographic>(done.scene.camera));
    CHECK(done.view().location == Vec3(1, 2, 3));
    CHECK(done.view().look_at == Vec3(0));
    CHECK(done.view().angle == 30);
    CHECK_FALSE(done.view().up);
    CHECK(done.view().transform.point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(std::holds_alternative<Perspective>(
        run("#version 3.7; camera { location 1 }").scene.camera));
}

TEST_CASE("cameras are declared, and have a default", "[bind]") {
    const Script done = run(
        "#version 3.7; #declare C = camera { orthographic location y } camera { C translate x }");
    REQUIRE(done.text.empty());
    CHECK(std::holds_alternative<Orthographic>(done.scene.camera));
    CHECK(done.view().transform.point(Vec3(0)) == Vec3(1, 0, 0));
    CHECK(run("#version 3.7; #default { camera { location y } } camera { orthographic }")
              .view()
              .location == Vec3(0, 1, 0));
    CHECK(run("#version 3.7; #default { camera { location y } }").view().location == Vec3(0, 1, 0));
}

TEST_CASE("of several cameras the last one counts", "[bind]") {
    const Script done = run("#version 3.7; camera { location x } camera { location y }");
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].fault == Fault::duplicate);
    CHECK(done.view().location == Vec3(0, 1, 0));
}

TEST_CASE("the opening of a lens has blades or a picture", "[bind]") {
    const Script bladed = run(
        "#version 3.7; camera { location -z aperture 1 blur_samples 9 bokeh { blades 6 angle 15 } "
        "}");
    REQUIRE(bladed.text.empty());
    CHECK(bladed.view().bokeh.blades == 6);
    CHECK(bladed.view().bokeh.angle == 15);
    CHECK_FALSE(bladed.scene.bokeh);
    const Script shown = run(
        "#version 3.7; #declare C = camera { location -z bokeh { pigment { radial } } } camera { C "
        "}");
    REQUIRE(shown.text.empty());
    CHECK(shown.scene.bokeh);
    for (const Script* const script : {&bladed, &shown}) {
        const std::string text = dump(script->scene);
        CHECK(text.find("bokeh { ") != std::string::npos);
        CHECK(dump(run(text).scene) == text);
    }
    CHECK(complaint("camera { bokeh { blades 65 } }") ==
          "error out-of-range: `blades` of `bokeh` must be from 0 to 64, but it is 65");
    CHECK(complaint("camera { bokeh { corners 5 } }").starts_with("error unknown-word"));
}

TEST_CASE("wrong cameras are told of once", "[bind]") {
    CHECK(complaint("camera { location x look_at x }") ==
          "error degenerate: `look_at` must not be the camera's own location");
    CHECK(complaint("camera { location x orthographic }") ==
          "error misplaced: the type `orthographic` must come first in `camera`");
    CHECK(complaint("camera { perspective angle 180 }") ==
          "error degenerate: `angle` of a flat picture must be below 180 degrees");
    CHECK(complaint("camera { cylinder 5 }") ==
          "error out-of-range: `type` of `camera` must be from 1 to 4, but it is 5");
    CHECK(complaint("camera { locaton x }") ==
          "error unknown-word: `camera` has no word `locaton`");
    CHECK(complaint("camera { look_at \"here\" }") ==
          "error wrong-type: `look_at` of `camera` must be a vector of 3, but it is a string");
}

TEST_CASE("before version 3.5 the order of a camera's words counts", "[bind]") {
    const char* const words = "angle 60 right 2*x";
    const auto length_at = [&](const char* version) {
        const Script done = run(std::string("#version ") + version + "; camera { " + words + " }");
        return length(projection(done.scene.camera).direction);
    };
    CHECK(length_at("3.1") == Approx(0.665 / std::tan(pi / 6)));
    CHECK(length_at("3.7") == Approx(1 / std::tan(pi / 6)));
}

TEST_CASE("a mesh_camera has its meshes in braces", "[bind]") {
    const std::string mesh = "mesh { triangle { 0, x, y } } ";
    const Script done = run("#version 3.7; #declare M = " + mesh +
                            "camera { mesh_camera { 2, 0 mesh { M } mesh { M translate z } smooth }"
                            " location <0, 0, -0.1> }");
    REQUIRE(done.text.empty());
    const auto& camera = std::get<MeshCamera>(done.scene.camera);
    REQUIRE(camera.from);
    CHECK(camera.from->rays == 2);
    CHECK(camera.from->smooth);
    REQUIRE(camera.from->meshes.size() == 2);
    CHECK(camera.from->meshes[1].transform.point(Vec3(0)) == Vec3(0, 0, 1));
    CHECK(camera.location.z == -0.1);

    const auto wrong = [](const std::string& content) {
        return run("#version 3.7; camera { " + content + " }").text;
    };
    CHECK(wrong("mesh_camera { 1, 0 }").find("`mesh_camera` needs a mesh") != std::string::npos);
    CHECK(wrong("mesh_camera").find("`mesh_camera` needs meshes in braces") != std::string::npos);
    CHECK(wrong("mesh_camera { 2, 0 " + mesh + "}").find("a mesh of its own") != std::string::npos);
    CHECK(wrong("mesh_camera { 1, 0 sphere { 0, 1 } }").find("start at meshes") !=
          std::string::npos);
}

TEST_CASE("a user_defined camera has functions for its rays", "[bind]") {
    const std::string both =
        "camera { user_defined location { function { x*4 } function { y*3 } function { -5 } } "
        "direction { function { u } function { v*v } function { 1 } } rotate 90*y }";
    const Script done = run("#version 3.7; " + both);
    REQUIRE(done.text.empty());
    const Projection camera = projection(done.scene.camera);
    CHECK(camera.ray(0.25, -0.5).origin == Vec3(1, -1.5, -5));
    CHECK(camera.ray(0.25, -0.5).direction == unit(Vec3(0.25, 0.25, 1)));

    // What is no function is the camera's own, and is moved with it.
    const Projection turned = projection(
        run("#version 3.7; camera { user_defined location { function { 1 } function { 2 } "
            "function { x/(x - 0.25) } } direction z rotate 90*y }")
            .scene.camera);
    CHECK(length(turned.ray(0, 0).direction - Vec3(1, 0, 0)) < 1e-12);
    CHECK(turned.ray(0, 0).origin == Vec3(1, 2, 0));
    // Where a function has no value there is no ray.
    CHECK(turned.ray(0.25, 0).direction == Vec3(0));

    CHECK(complaint("camera { user_defined direction { function { x } } }") ==
          "error missing: `direction` needs `y` and `z`");
    CHECK(complaint("camera { user_defined angle 30 }") ==
          "error degenerate: `angle` has no place beside the functions of a `user_defined` camera");
    CHECK(complaint("camera { location { function { x } function { x } function { x } } }") != "");
    CHECK(complaint("camera { user_defined look_at x direction { function { x } function { y } "
                    "function { 1 } } }") ==
          "warning no-effect: `look_at` has no effect: functions give the directions of the rays");
    // The word stays a name for scenes that declare it.
    CHECK(run("#version 3.7; #declare user_defined = 1; sphere { 0, user_defined }").text.empty());
}

TEST_CASE("a shutter has its time and its moments", "[bind]") {
    const Script done = run("#version 3.7; camera { shutter 0.5, 12 }");
    REQUIRE(done.text.empty());
    CHECK(done.view().shutter == 0.5);
    CHECK(done.view().moments == 12);
    CHECK(run("#version 3.7; camera { shutter 0.5 }").view().moments == 8);
}

}  // namespace candelabra
