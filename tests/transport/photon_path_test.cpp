// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_path.h"

#include "support/ball_lens.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

const std::string sun_for_photons =
    "light_source { 90*y, rgb 1 parallel point_at 0 photons { refraction on reflection on } } ";

std::vector<Photon> photons_in(const Shot& shot, std::uint32_t count = 1 << 14) {
    const PhotonShooter shooter(shot);
    const PhotonPaths paths(shot);
    std::vector<Photon> found;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Key key{3, i, 0, 0};
        if (const auto shot = shooter.shoot(shooter.aims().front(), key))
            paths.follow(*shot, key, 1.0 / count, found);
    }
    return found;
}

double power_of(const std::vector<Photon>& photons) {
    double sum = 0;
    for (const Photon& photon : photons) sum += photon.power.y;
    return sum;
}

Shot with_photons(const std::string& objects, const std::string& more = "") {
    return shot_of("#version 3.7; global_settings { photons { count 100 " + more + " } } " +
                   sun_for_photons + objects);
}

const std::string floor_below = "plane { y, 0 pigment { rgb 1 } } ";

/// A ball of radius 1, with more of its finish and of its other attributes.
std::string ball_at(double height, const std::string& finish = "", const std::string& more = "") {
    return "sphere { " + std::to_string(height) +
           "*y, 1 pigment { rgbt 1 } interior { ior 1.5 } finish { diffuse 0 " + finish +
           " } photons { target " + more + " } } ";
}

}  // namespace

TEST_CASE("a ball of glass sends light where exact geometry says", "[transport][statistics]") {
    const BallLens lens;
    const auto photons = photons_in(with_photons(floor_below + ball_at(lens.height)), 1 << 16);
    CHECK(power_of(photons) == Approx(lens.area_within(1e9)).epsilon(1e-3));
    for (double from = 0.5; from < 4; from += 0.5) {
        double power = 0;
        for (const Photon& photon : photons) {
            const double away = length(photon.position);
            if (away >= from && away < from + 0.5) power += photon.power.x;
        }
        CHECK(power == Approx(lens.area_within(from + 0.5) - lens.area_within(from))
                           .epsilon(0.02)
                           .margin(1e-3));
    }
}

TEST_CASE("no light is lost in glass that also reflects", "[transport]") {
    // Light that a mirror sends up would be lost; a shell around everything holds it.
    const Shot shot = shot_of(
        "#version 3.7; global_settings { photons { count 100 max_trace_level 50 adc_bailout 0 } } "
        "light_source { 20*y, rgb 1 parallel point_at 0 photons { refraction on reflection on } "
        "} " +
        ball_at(0, "reflection { 1 fresnel } conserve_energy") +
        "sphere { 0, 50 hollow pigment { rgb 1 } }");
    const auto photons = photons_in(shot);
    CHECK(power_of(photons) == Approx(pi).epsilon(0.01));
}

TEST_CASE("photons take the colours of what they pass", "[transport]") {
    const std::string coloured =
        "box { <-1, 3, -1>, <1, 4, 1> pigment { rgbf <0.9, 0.5, 0.2, 1> } finish { diffuse 0 } "
        "photons { target } } ";
    const auto photons = photons_in(with_photons(floor_below + coloured));
    REQUIRE_FALSE(photons.empty());
    double red = 0, green = 0;
    for (const Photon& photon : photons) {
        red += photon.power.x;
        green += photon.power.y;
    }
    CHECK(red == Approx(4 * 0.81).epsilon(0.01));
    CHECK(green == Approx(4 * 0.25).epsilon(0.01));
    // The interior attenuates light with distance.
    const auto dimmed = photons_in(
        with_photons(floor_below + "box { <-1, 3, -1>, <1, 4, 1> pigment { rgbt 1 } finish { "
                                   "diffuse 0 } interior { fade_distance 1 "
                                   "fade_power 1001 fade_color rgb 0.5 } photons { target } } "));
    CHECK(power_of(dimmed) == Approx(4 * std::exp(-0.5)).epsilon(0.01));
}

TEST_CASE("what is not to be reflected or refracted is not", "[transport]") {
    CHECK(photons_in(with_photons(floor_below + ball_at(5, "", "refraction off"))).empty());
    const std::string shiny = "reflection 0.5";
    const double through = power_of(photons_in(with_photons(floor_below + ball_at(5, shiny))));
    const double without =
        power_of(photons_in(with_photons(floor_below + ball_at(5, shiny, "reflection off"))));
    CHECK(without == Approx(pi).epsilon(0.01));
    CHECK(through != Approx(pi).epsilon(0.05));
}

TEST_CASE("before its target a photon passes what is clear, and nothing else", "[transport]") {
    const auto below = [](const std::string& object) {
        return power_of(photons_in(with_photons(floor_below + ball_at(5) + object)));
    };
    CHECK(below("box { <-9, 10, -9>, <9, 11, 9> pigment { rgbf 0.5 } }") ==
          Approx(pi / 16).epsilon(0.01));
    CHECK(below("box { <-9, 10, -9>, <9, 11, 9> pigment { rgb 0.5 } }") == 0);
    CHECK(below("box { <-9, 10, -9>, <9, 11, 9> pigment { rgb 0.5 } no_shadow }") ==
          Approx(pi).epsilon(0.01));
    // Light that passes through another target is shot at that target.
    CHECK(below("box { <-9, 10, -9>, <9, 11, 9> pigment { rgbt 1 } photons { target } }") == 0);
}

TEST_CASE("a photon meets as many surfaces as it may", "[transport]") {
    const std::string scene = floor_below + ball_at(5);
    CHECK(photons_in(with_photons(scene, "max_trace_level 2")).empty());
    CHECK_FALSE(photons_in(with_photons(scene, "max_trace_level 3")).empty());
    CHECK(photons_in(
              with_photons(floor_below + ball_at(5, "", "") +
                               "plane { y, 1 hollow pigment { rgbt 0.1 } finish { diffuse 0 } }",
                           "adc_bailout 0.5"))
              .empty());
}

TEST_CASE("photons of a light group light what the group lights", "[transport]") {
    const std::string right = "box { <0, -1, -5>, <5, 0, 5> pigment { rgb 1 } } ",
                      left = "box { <-5, -1, -5>, <0, 0, 5> pigment { rgb 1 } } ";
    const auto on_sides = [](const std::string& scene) {
        const Shot shot =
            shot_of("#version 3.7; global_settings { photons { count 100 } } " + scene);
        std::pair<int, int> found{0, 0};
        for (const Photon& photon : photons_in(shot))
            ++(photon.position.x < 0 ? found.first : found.second);
        return found;
    };
    const auto all = on_sides(sun_for_photons + ball_at(4) + left + right);
    CHECK(all.first > 100);
    CHECK(all.second > 100);
    const auto grouped =
        on_sides("light_group { " + sun_for_photons + ball_at(4) + left + "} " + right);
    CHECK(grouped.first == all.first);
    CHECK(grouped.second == 0);
    const auto outer = on_sides(sun_for_photons + ball_at(4) + "light_group { " + left +
                                "} light_group { " + right + "global_lights on } ");
    CHECK(outer.first == 0);
    CHECK(outer.second == all.second);
}

TEST_CASE("only surfaces that collect get photons, and that show light", "[transport]") {
    const auto come_to = [](const std::string& more) {
        return photons_in(with_photons("plane { y, 0 " + more + " } " + ball_at(5))).size();
    };
    CHECK(come_to("pigment { rgb 1 }") > 0);
    CHECK(come_to("pigment { rgb 1 } photons { collect off }") == 0);
    CHECK(come_to("pigment { rgb 1 } finish { diffuse 0 }") == 0);
}

TEST_CASE("a photon that is totally reflected has no more than what would pass", "[transport]") {
    // Straight into a prism, from whose long face all light is reflected to the side.
    const auto power = [](const std::string& pigment) {
        double sum = 0;
        for (const Photon& photon : photons_in(with_photons(
                 "box { <-50, -50, -50>, <50, -40, 50> pigment { rgb 1 } } "
                 "box { <5, -9, -9>, <6, 9, 9> pigment { rgb 1 } } "
                 "prism { -1, 1, 4, <-1, -1>, <1, 1>, <-1, 1>, <-1, -1> rotate -90*x scale <-1, 1, "
                 "1> " +
                 pigment + " finish { diffuse 0.9 } interior { ior 1.5 } photons { target } }")))
            if (photon.position.x > 4.9) sum += photon.power.y;
        return sum;
    };
    const double clear = power("pigment { rgbt 1 }");
    REQUIRE(clear == Approx(4).epsilon(0.02));
    CHECK(power("pigment { rgbt <1, 1, 1, 0.6> }") ==
          Approx(0.6 * 0.6 * 0.6 * clear).epsilon(0.02));
}

}  // namespace candelabra
