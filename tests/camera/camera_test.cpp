// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

TEST_CASE("a camera that looks along the sky is mirrored as POV-Ray's", "[camera]") {
    Perspective camera;
    camera.location = Vec3(0, 6, 0);
    camera.look_at = Vec3(0);
    CHECK(near(projection(camera).right, Vec3(1.33, 0, 0)));
    camera.right = Vec3(-1.33, 0, 0);
    CHECK(near(projection(camera).right, Vec3(1.33, 0, 0)));
    camera.right = Vec3(1.33, 0, 0);
    camera.up = Vec3(0, 0, 1);  // along the direction, as it was
    CHECK(near(projection(camera).right, Vec3(-1.33, 0, 0)));
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
    Perspective at_itself, wide;
    at_itself.look_at = Vec3(0);
    wide.angle = 180;
    for (const Perspective& camera : {at_itself, wide}) CHECK_FALSE(problem(camera).empty());
    CHECK(problem(Perspective{}).empty());
}

TEST_CASE("a camera with vectors in one plane sees stripes or nothing", "[camera]") {
    CHECK_FALSE(is_flattened(Perspective{}));
    Perspective stripes, nowhere;
    stripes.right = Vec3(0);
    CHECK(is_flattened(stripes));
    CHECK(projection(stripes).ray(0.4, 0.2).direction ==
          projection(stripes).ray(-0.1, 0.2).direction);
    nowhere.direction = Vec3(0);
    CHECK(is_flattened(nowhere));
    CHECK(projection(nowhere).ray(0, 0).direction == Vec3(0));
    SphericalCamera skewed, axisless;
    skewed.up = Vec3(0, 1, 1);
    CHECK_FALSE(is_flattened(skewed));
    axisless.up = Vec3(0);
    CHECK(is_flattened(axisless));
    const auto rays_of = [](auto camera) {
        camera.right = camera.up = camera.direction = Vec3(0);
        for (const double u : {-0.5, 0.0, 0.3})
            for (const double v : {-0.5, 0.0, 0.3}) {
                const Vec3 towards = projection(camera).ray(u, v).direction;
                CHECK((towards == Vec3(0) || length(towards) == Approx(1)));
            }
    };
    rays_of(Orthographic{});
    rays_of(Fisheye{});
    rays_of(UltraWideAngle{});
    rays_of(Omnimax{});
    rays_of(Panoramic{});
    rays_of(CylinderCamera{});
    rays_of(SphericalCamera{});
}

TEST_CASE("with an angle and no direction there is nothing to see", "[camera]") {
    Perspective camera;
    camera.direction = Vec3(0);
    CHECK(projection(camera).ray(0.3, 0.2).direction != Vec3(0));
    camera.angle = 40;
    CHECK(projection(camera).ray(0.3, 0.2).direction == Vec3(0));
}

TEST_CASE("a focal point in the camera's place is as none", "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    camera.blur_samples = 4;
    camera.direction = Vec3(0, 0, 2);
    camera.focal_point = camera.location;
    CHECK(projection(camera).focal_distance == 2);
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

TEST_CASE("rays through a lens meet where it is sharp", "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    camera.blur_samples = 40;
    camera.focal_point = Vec3(0, 3, 4);
    const Projection view = projection(camera);
    const Ray middle = view.ray(0.3, -0.2);
    const Vec3 sharp = middle.at(5 / middle.direction.z);
    Vec3 squares(0);
    constexpr int steps = 50;
    for (int i = 0; i < steps * steps; ++i) {
        const Ray ray = view.through_lens(
            middle, {(i % steps + 0.5) / steps, (static_cast<double>(i / steps) + 0.5) / steps});
        CHECK(length(ray.origin) <= 0.25);
        CHECK(near(ray.at(length(sharp - ray.origin)), sharp));
        squares += ray.origin * ray.origin;
    }
    // A disc of radius r has a standard deviation of r / 2 along each axis.
    CHECK(squares.x / (steps * steps) == Approx(0.125 * 0.125).epsilon(1e-3));
    CHECK(squares.y / (steps * steps) == Approx(0.125 * 0.125).epsilon(1e-3));
    CHECK(squares.z == Approx(0).margin(1e-20));
}

TEST_CASE("a blurred pixel gets rays until its mean is known", "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    camera.blur_samples = 10;
    camera.max_blur_samples = 50;
    camera.variance = 0.01;
    const BlurRays rule = projection(camera).blur;
    CHECK(rule.allowed(9) < 0);
    CHECK(rule.allowed(50) > 1e300);
    CHECK(rule.allowed(49) == Approx(0.01));
    // 0.9 quantiles of the chi-squared distribution with 10 and 49 degrees of freedom.
    CHECK(rule.allowed(10) == Approx(0.01 * 15.987 / 62.038).epsilon(0.01));
}

TEST_CASE("a blurred pixel whose variance is to be 0 gets all rays, however alike they are",
          "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    camera.blur_samples = 50;
    camera.variance = 0;
    const BlurRays rule = projection(camera).blur;
    CHECK(rule.allowed(7) < 0);
    CHECK(rule.allowed(49) < 0);
    CHECK(rule.allowed(50) > 1e300);
}

TEST_CASE("lens and focal distance are the same wherever the camera goes", "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    camera.blur_samples = 40;
    camera.location = Vec3(0, 2, -10);
    camera.direction = Vec3(0, 0, 2);
    camera.transform = Transform::scaling(Vec3(3));
    CHECK(projection(camera).focal_distance == Approx(2));
    camera.focal_point = Vec3(0, 2, -5);
    CHECK(projection(camera).focal_distance == Approx(5));
    CHECK(projection(camera).lens_radius == Approx(0.25));
}

TEST_CASE("the least number of rays follows from the greatest", "[camera]") {
    Perspective camera;
    camera.aperture = 1;
    const auto least = [&](int most) {
        camera.blur_samples = most;
        return projection(camera).blur.least;
    };
    CHECK(least(3) == 3);
    CHECK(least(4) == 4);
    CHECK(least(6) == 4);
    CHECK(least(7) == 7);
    CHECK(least(200) == 7);
    camera.max_blur_samples = 300;
    CHECK(least(20) == 20);
}

TEST_CASE("parallel rays with an angle see as much as others do at what is looked at", "[camera]") {
    Orthographic camera;
    camera.location = Vec3(0, 0, -10);
    camera.look_at = Vec3(0);
    camera.right = Vec3(0.4, 0, 0);
    CHECK(length(projection(camera).right) == Approx(0.4));
    camera.angle = 0;
    CHECK(length(projection(camera).right) == Approx(4));
    camera.direction = Vec3(0, 0, 2);
    CHECK(length(projection(camera).right) == Approx(2));
    camera.angle = 90;
    CHECK(length(projection(camera).right) == Approx(20));
    SphericalCamera around;
    around.angle = 0;
    CHECK(projection(around).angle == Approx(projection(SphericalCamera()).angle));
}

}  // namespace candelabra
