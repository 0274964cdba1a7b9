// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera.h"

#include <catch2/catch.hpp>

namespace {

bool near(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-12; }

}  // namespace

TEST_CASE("the default camera is POV-Ray's", "[camera]") {
    const Projection view = projection(Perspective{});
    CHECK(near(view.ray(0, 0).direction, Vec3(0, 0, 1)));
    CHECK(near(view.ray(0.5, 0).direction, unit(Vec3(0.665, 0, 1))));
    CHECK(near(view.ray(0, 0.5).direction, unit(Vec3(0, 0.5, 1))));
}

TEST_CASE("angle sets the length of the direction", "[camera]") {
    Perspective camera;
    camera.angle = 90;
    camera.right = Vec3(2, 0, 0);
    CHECK(near(projection(camera).direction, Vec3(0, 0, 1)));
}

TEST_CASE("look_at keeps lengths and handedness", "[camera]") {
    Perspective camera;
    camera.location = Vec3(0, 0, -5);
    camera.look_at = Vec3(0);
    Projection view = projection(camera);
    CHECK(near(view.right, Vec3(1.33, 0, 0)));
    CHECK(near(view.up, Vec3(0, 1, 0)));

    camera.right = Vec3(-1.33, 0, 0);  // right-handed
    view = projection(camera);
    CHECK(near(view.right, Vec3(-1.33, 0, 0)));
    CHECK(near(view.up, Vec3(0, 1, 0)));

    camera.location = Vec3(0, -10, 7);
    camera.sky = Vec3(0, 0, 1);
    camera.look_at = Vec3(0, 0, 0.7);
    view = projection(camera);
    CHECK(near(unit(view.direction), unit(Vec3(0, 10, -6.3))));
    CHECK(view.up.z > 0);
    CHECK(dot(view.up, view.direction) == Approx(0).margin(1e-12));
}

TEST_CASE("a camera whose up is its direction shows the picture mirrored", "[camera]") {
    Perspective camera;
    camera.up = camera.sky = Vec3(0, 0, 1);
    camera.location = Vec3(0, 3.3, 0);
    camera.look_at = Vec3(0);
    CHECK(near(projection(camera).right, Vec3(-1.33, 0, 0)));
}

TEST_CASE("an orthographic camera is as wide as its distance says", "[camera]") {
    Orthographic camera;
    camera.location = Vec3(0, 0, -4);
    camera.look_at = Vec3(0);
    const Ray ray = projection(camera).ray(0.5, 0);
    CHECK(near(ray.origin, Vec3(0.5 * 1.33 * 4, 0, -4)));
    CHECK(near(ray.direction, Vec3(0, 0, 1)));

    camera.right = Vec3(2, 0, 0);
    CHECK(near(projection(camera).ray(0.5, 0).origin, Vec3(1, 0, -4)));
}

TEST_CASE("transforms move the whole camera", "[camera]") {
    Perspective camera;
    camera.location = Vec3(1, 2, 3);
    camera.transform = Transform::rotation(Vec3(0, 90, 0));
    const Ray ray = projection(camera).ray(0, 0);
    CHECK(near(ray.origin, Vec3(3, 2, -1)));
    CHECK(near(ray.direction, Vec3(1, 0, 0)));
}

TEST_CASE("an impossible camera is described", "[camera]") {
    Perspective at_itself, flat, wide, zero;
    at_itself.look_at = Vec3(0);
    flat.right = Vec3(0, 0, 1);
    wide.angle = 180;
    zero.up = Vec3(0);
    for (const Perspective& camera : {at_itself, flat, wide, zero})
        CHECK_FALSE(problem(camera).empty());
    CHECK(problem(Perspective{}).empty());
}

TEST_CASE("wide lenses send rays as POV-Ray 3.7's", "[camera]") {
    Fisheye fisheye;
    fisheye.right = Vec3(1, 0, 0);
    fisheye.angle = 180;
    CHECK(near(projection(fisheye).ray(0.25, 0).direction, unit(Vec3(1, 0, 1))));
    CHECK(projection(fisheye).ray(0.5, 0.5).direction == Vec3(0));
    SphericalCamera around;
    CHECK(near(projection(around).ray(0.25, 0).direction, Vec3(1, 0, 0)));
    CHECK(near(projection(around).ray(0, 0.25).direction, unit(Vec3(0, 1, 1))));
    CylinderCamera cylinder;
    cylinder.type = 3;
    cylinder.angle = 90;
    CHECK(near(projection(cylinder).ray(0.5, 0.5).origin, Vec3(0, 0.5, 0)));
    CHECK(near(projection(cylinder).ray(0.5, 0.5).direction, unit(Vec3(1, 0, 1))));
    CHECK(near(projection(Panoramic()).ray(0, 0).direction, Vec3(0, 0, 1)));
}
