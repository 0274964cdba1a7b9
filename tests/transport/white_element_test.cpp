// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/white_element.h"

#include "support/rgb.h"
#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

/// What an element at the origin shows of a script's light, on average.
Rgb element_shows(const std::string& script, const Vec3& normal, int samples = 256) {
    const Shot shot = shot_of("#version 3.7; #default { finish { ambient 0 } } " + script);
    Integrator integrator(shot, {.from_anywhere = true});
    Rgb sum(0);
    for (int i = 0; i < samples; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        sum += integrator.element_radiance(WhiteElement(Vec3(0), normal), key);
    }
    return sum / static_cast<double>(samples);
}

}  // namespace

TEST_CASE("an element shows its light by every integrator", "[transport]") {
    for (const std::string integrator : {"pov_ray", "path_traced"}) {
        CAPTURE(integrator);
        const std::string by = "global_settings { integrator { " + integrator + " } } ";
        CHECK(length(element_shows(by + "light_source { 5*y, rgb <1, 0.5, 0> }", Vec3(0, 1, 0)) -
                     Rgb(1, 0.5, 0)) < 1e-9);
        CHECK(element_shows(by + "light_source { 5*y, rgb 1 }", Vec3(0, -1, 0)) == Rgb(0));
        // A sphere of radiance 1 that covers a hundredth of the light's hemisphere.
        const Rgb ball = element_shows(
            by + "plane { y, -1 } sphere { 10*y, 1 pigment { rgb 1 } finish { emission 1 diffuse "
                 "0 } }",
            Vec3(0, 1, 0));
        CHECK(ball.r == Approx(0.01).epsilon(1e-6));
    }
    // A path finds what other surfaces reflect, and the sky; the element has no light of its own.
    const std::string traced = "global_settings { integrator { path_traced } } ";
    CHECK(element_shows(traced + "background { rgb 0.5 }", Vec3(0, 1, 0)).r == Approx(0.5));
    CHECK(element_shows(traced + "background { rgb 0.5 } plane { y, 1 }", Vec3(0, 1, 0)).r < 0.5);
    CHECK(element_shows(traced, Vec3(0, 1, 0)) == Rgb(0));
}

TEST_CASE("an element on a surface is lit as the surface, and in a solid as in it", "[transport]") {
    const std::string lamp = "light_source { 5*y, rgb 1 } ";
    CHECK(element_shows(lamp + "plane { y, 0 }", Vec3(0, 1, 0)).r == Approx(1));
    CHECK(element_shows(lamp + "plane { y, 0 inverse }", Vec3(0, 1, 0)).r == Approx(1));
    CHECK(element_shows(lamp + "box { -1, 1 }", Vec3(0, 1, 0)) == Rgb(0));
    const Rgb inside = element_shows(
        lamp + "box { -1, 1 pigment { rgb <1, 0.5, 0.25> filter 1 } hollow }", Vec3(0, 1, 0));
    CHECK(inside.g == Approx(0.5 * inside.r));
    CHECK(inside.r > 0);
}

}  // namespace candelabra
