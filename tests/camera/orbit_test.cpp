// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/orbit.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

bool close_to(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-9; }

/// Looks at the origin from five units in front of it.
Sight in_front(const Vec3& right = {1.33, 0, 0}) {
    Perspective camera;
    camera.location = Vec3(0, 0, -5);
    camera.look_at = Vec3(0);
    camera.right = right;
    return {projection(camera), 5};
}

}  // namespace

TEST_CASE("a camera that is turned goes around its point and looks at it", "[camera]") {
    const Sight given = in_front();
    Orbit orbit;
    CHECK_FALSE(orbit.moved());
    CHECK(close_to(orbit.place(given).camera.location, given.camera.location));
    orbit.turn(given, 90, 0);
    CHECK(orbit.moved());
    Sight now = orbit.place(given);
    CHECK(close_to(now.camera.location, Vec3(5, 0, 0)));
    CHECK(close_to(unit(now.camera.direction), Vec3(-1, 0, 0)));
    CHECK(close_to(now.camera.right, Vec3(0, 0, 1.33)));
    orbit.turn(given, 0, 30);
    now = orbit.place(given);
    CHECK(now.camera.location.y == Approx(2.5));
    CHECK(now.camera.up.y > 0);
    CHECK(length(now.camera.location) == Approx(5));
    orbit.reset();
    CHECK(close_to(orbit.place(given).camera.location, given.camera.location));
}

TEST_CASE("right is right in scenes of both hands, and nobody goes over the top", "[camera]") {
    const Sight mirrored = in_front(Vec3(-1.33, 0, 0));
    Orbit orbit;
    orbit.turn(mirrored, 90, 0);
    CHECK(close_to(orbit.place(mirrored).camera.location, Vec3(-5, 0, 0)));
    orbit.turn(mirrored, 0, 500);
    const Projection top = orbit.place(mirrored).camera;
    CHECK(top.location.y < 5);
    CHECK(top.location.y > 4.99);
    CHECK(top.up.y > 0);
    orbit.turn(mirrored, 0, -89);
    CHECK(std::abs(orbit.place(mirrored).camera.location.y) < 1e-9);
}

TEST_CASE("a camera is moved across what it sees, and nearer", "[camera]") {
    const Sight given = in_front();
    Orbit orbit;
    orbit.pan(given, 0.5, 0);
    CHECK(close_to(orbit.place(given).camera.location, Vec3(0.5 * 1.33 * 5, 0, -5)));
    orbit.approach(0.5);
    CHECK(orbit.place(given).camera.location.z == Approx(-2.5));
    CHECK(orbit.place(given).distance == Approx(2.5));
    orbit.approach(0);
    orbit.approach(-1);
    CHECK(orbit.place(given).distance == Approx(2.5));
    for (int i = 0; i < 100; ++i) orbit.approach(0.1);
    CHECK(orbit.place(given).distance > 0);

    Orthographic parallel;
    parallel.location = Vec3(0, 0, -5);
    const Sight flat{projection(parallel), 5};
    Orbit zoom;
    zoom.approach(0.5);
    CHECK(close_to(zoom.place(flat).camera.right, 0.5 * flat.camera.right));
    CHECK(close_to(zoom.place(flat).camera.location, flat.camera.location));
}

TEST_CASE("what is sharp stays so when the camera comes nearer", "[camera]") {
    Sight given = in_front();
    given.camera.lens_radius = 0.1;
    given.camera.focal_distance = 5;
    Orbit orbit;
    orbit.approach(0.4);
    CHECK(orbit.place(given).camera.focal_distance == Approx(2));
}

TEST_CASE("cameras of meshes stay where they are", "[camera]") {
    CHECK(can_orbit(projection(Perspective{})));
    CHECK_FALSE(can_orbit(projection(MeshCamera{})));
}

TEST_CASE("a camera is written as a block that means the same", "[camera]") {
    CHECK(camera_script(in_front()) ==
          "camera {\n  perspective\n  location <0, 0, -5>\n  right 1.33*x up 1*y direction 1*z\n"
          "  sky <0, 1, 0>\n  look_at <0, 0, 0>\n}\n");
    Fisheye round;
    round.angle = 160;
    CHECK(camera_script({projection(round), 1}) ==
          "camera {\n  fisheye angle 160\n  location <0, 0, 0>\n  direction <0, 0, 1>\n"
          "  right <1.33, 0, 0>\n  up <0, 1, 0>\n}\n");
}

}  // namespace candelabra
