// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/camera_ray.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace candelabra {

TEST_CASE("the normal of a camera bends its rays as POV-Ray does", "[render]") {
    struct Case {
        const char* camera;
        Vec3 along_x, along_y;  // by POV-Ray 3.7, in steps of 1/32768: bumps along x, along y
    };
    const Case cases[] = {
        {"perspective angle 45", {0.1816, 0.2029, 0.9622}, {-0.1029, -0.0463, 0.9936}},
        {"orthographic", {0.2739, 0.0035, 0.9618}, {0.0000, -0.2399, 0.9708}},
        {"fisheye angle 120", {-0.3786, 0.6174, 0.6895}, {-0.2664, 0.7530, 0.6016}},
        {"ultra_wide_angle angle 80 up 2*y", {0.1248, 0.6415, 0.7569}, {-0.1548, 0.7238, 0.6724}},
        {"omnimax", {-0.0825, 0.8939, 0.4405}, {-0.3289, 0.8252, 0.4592}},
        {"panoramic angle 90", {0.0688, 0.8807, 0.4686}, {-0.1939, 0.9161, 0.3511}},
        {"spherical angle 90 50", {0.0104, 0.2866, 0.9580}, {-0.1949, -0.0461, 0.9797}},
        {"cylinder 1 angle 80 up 1.5*y", {0.1414, 0.4455, 0.8840}, {-0.1440, 0.5586, 0.8169}},
        {"cylinder 2 angle 80", {0.1538, 0.4416, 0.8839}, {-0.1402, 0.6443, 0.7518}},
        {"cylinder 3 angle 90", {0.0020, -0.0058, 1.0000}, {-0.1894, -0.2399, 0.9521}},
        {"cylinder 4 angle 90", {0.3031, 0.4748, 0.8262}, {0.0000, 0.4968, 0.8678}},
    };
    for (const Case& c : cases)
        for (const bool along_y : {false, true}) {
            INFO(c.camera);
            const Shot shot = shot_of("#version 3.7; camera { " + std::string(c.camera) +
                                      " location 0 right 4/3*x normal { gradient " +
                                      (along_y ? "y" : "x") + " 0.8 sine_wave scale 0.3 } }");
            const Vec3 found = camera_ray(shot, 1.5 / 4 - 0.5, 0.5 - 0.5 / 3, Key()).direction;
            CHECK(max_abs_component(found - (along_y ? c.along_y : c.along_x)) < 2e-4);
        }
}

TEST_CASE("the ray through a pixel's middle has no chance in it", "[render]") {
    const Shot shot =
        shot_of("camera { location -5*z look_at 0 aperture 1 blur_samples 4 focal_point 0 }");
    const PicturePoint at{3, 2, 8, 6};
    const Ray ray = middle_ray(shot, at);
    CHECK(ray.origin == Vec3(0, 0, -5));
    Key other;
    other.sample = 7;
    CHECK(ray_through(shot, at, {0.5, 0.5}, Key()).origin !=
          ray_through(shot, at, {0.5, 0.5}, other).origin);
}

TEST_CASE("rays start where the lens is open", "[render]") {
    const auto starts = [](const std::string& bokeh) {
        const Shot shot = shot_of(
            "camera { location -5*z look_at 0 aperture 4 blur_samples 9 focal_point 0 bokeh { " +
            bokeh + " } }");
        std::vector<Vec3> found;
        for (std::uint32_t sample = 0; sample < 500; ++sample) {
            Key key;
            key.sample = sample;
            found.push_back(ray_through(shot, {3, 2, 8, 6}, {0.5, 0.5}, key).origin);
        }
        return found;
    };
    for (const Vec3& start : starts("blades 4 angle 45"))  // a square of edges along x and y
        CHECK(std::max(std::abs(start.x), std::abs(start.y)) < 1 / std::sqrt(2) + 1e-9);
    double right = 0, above = 0;
    for (const Vec3& start :
         starts("pigment { gradient x color_map { [0.5 rgb 0] [0.5 rgb 1] } }")) {
        CHECK(start.x > 0);
        CHECK(start.x < 1);
        right += start.x / 500;
        above += start.y / 500;
    }
    CHECK(right == Approx(0.5).margin(0.06));
    CHECK(above == Approx(0).margin(0.1));
}

}  // namespace candelabra
