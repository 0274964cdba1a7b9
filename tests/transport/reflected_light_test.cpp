// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_light.h"

#include "support/scripts.h"
#include "transport/integrator.h"
#include "transport/reflecting_room.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Mean of many samples of one ray, and its standard deviation.
struct Estimate {
    Rgb mean;
    Rgb deviation;
};
Estimate estimate(const Shot& shot, std::uint32_t generations, const Ray& ray) {
    Integrator integrator(shot, {});
    // Samples of one generation depend on each other, so their mean counts as one sample.
    constexpr std::uint32_t pixels = 24, served = 4;
    Rgb sum(0), squares(0);
    for (std::uint32_t generation = 0; generation < generations; ++generation) {
        Rgb part(0);
        for (std::uint32_t i = 0; i < pixels * served; ++i)
            part += integrator.radiance(ray, {i % pixels, served * generation + i / pixels, 0, 0});
        part /= static_cast<double>(pixels * served);
        sum += part;
        squares += part * part;
    }
    const Rgb mean = sum / static_cast<double>(generations);
    const Rgb variance = squares / static_cast<double>(generations) - mean * mean;
    return {mean, sqrt(max(variance, Rgb(0)) / static_cast<double>(generations))};
}
Estimate estimate(const std::string& script, std::uint32_t generations, const Ray& ray) {
    return estimate(shot_of(script), generations, ray);
}

/// Checks that two places are as bright with reflected luminaires as by paths alone.
void check_same(const char* name, const std::string& scene, std::uint32_t generations) {
    const Vec3 eye(0.3, 1.4, -2.5);
    // Rays begin in what is around the camera.
    const std::string camera = "camera { location <0.3, 1.4, -2.5> look_at <0, 1, 0> }";
    const Shot by_paths = shot_of(with_reflected(0, 4) + camera + scene),
               with_luminaires = shot_of(with_reflected(300, 4) + camera + scene);
    for (const Vec3& towards : {Vec3(-1.2, 0, -0.5), Vec3(0.6, 0.5, 1.9)}) {
        const Ray ray{eye, unit(towards - eye)};
        const Estimate traced = estimate(by_paths, generations, ray),
                       reflected = estimate(with_luminaires, generations, ray);
        CAPTURE(name, towards.x, traced.mean.r, reflected.mean.r);
        for (int i = 0; i < 3; ++i) {
            const double sigma = std::hypot(traced.deviation[i], reflected.deviation[i]);
            CHECK(std::abs(traced.mean[i] - reflected.mean[i]) < 4 * sigma);
            CHECK(sigma < 0.06 * traced.mean[i]);
        }
    }
}

}  // namespace

TEST_CASE("reflected luminaires give what path tracing gives", "[transport]") {
    struct Row {
        const char* name;
        std::string scene;
        std::uint32_t generations = 45;
    };
    const Row rows[] = {
        {"diffuse", bare_room},
        {"highlights and a mirror",
         bare_room +
             "sphere { <1.2, 0.5, 0>, 0.5 pigment { rgb 0.6 } finish { phong 0.8 specular 0.4 } }"
             "box { <2.8, 0.5, -2>, <2.9, 2.5, 2> pigment { rgb 0.2 } finish { reflection 0.7 } }",
         270},  // rare samples are large: reflected luminaires in a highlight, near the ball
        {"glass and clear panes",
         bare_room +
             "sphere { <0.8, 1, -0.8>, 0.6 pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { diffuse "
             "0.1 reflection { 0, 1 fresnel } } interior { ior 1.4 } }"
             "box { <-3, 1.5, -0.1>, <3, 1.6, 3> pigment { rgbt <0.5, 0.5, 0.9, 0.6> } }"},
        {"facets, layers and two-sided surfaces",
         bare_room +
             "sphere { <1.2, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.6, 0.3> } finish { microfacet { "
             "roughness 0.4 metallic 1 } } }"
             "disc { <0, 1.5, 1.5>, z, 1 pigment { rgb 0.8 } finish { diffuse 0.4, 0.4 } }"
             "sphere { <-1.8, 0.5, -1>, 0.5 texture { pigment { rgb 0.7 } } texture { pigment { "
             "rgbt <1, 0.2, 0, 0.5> } } }"},
        {"lamps behind shades and a screen that has an inner side",
         bare_room +
             "#for (I, 0, 3) cylinder { <I - 1.5, 2.2, 0.5>, <I - 1.5, 2.9, 0.5>, 0.35 open "
             "pigment { "
             "rgb <0.9, 0.7, 0.5> } finish { diffuse 0.45, 0.4 } } #end "
             "cylinder { <-2, 0, 1.8>, <-2, 2, 1.8>, 0.8 open texture { pigment { rgb <0.3, 0.8, "
             "0.4> "
             "} finish { diffuse 0.3, 0.6 } } interior_texture { pigment { rgb <0.9, 0.3, 0.2> } "
             "finish { diffuse 0.5, 0.1 } } }"},
        {"other light",
         bare_room +
             "sphere { <1.2, 0.6, 0>, 0.4 pigment { rgb 1 } finish { emission 1 no_luminaire } }"
             "light_source { <2, 2, -2>, 0.6 }",
         300},  // enough to see light lost that glows without being a luminaire
        {"looks that depend on the direction of the ray",
         "box { <-3, 0, -3>, <3, 3, 3> pigment { aoi color_map { [0.5 rgb <0.9, 0.2, 0.1>] "
         "[0.9 rgb <0.3, 0.7, 0.9>] } } }"
         "box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <0.3, 0.4, 0.8> } }"},
        {"faces between two looks",
         bare_room +
             "mesh2 { vertex_vectors { 4, <0.2, 0, 1>, <2, 0, 1>, <2, 2, 1.4>, <0.2, 2, 1.4> } "
             "texture_list { 2, texture { pigment { rgb 0.7 } } texture { pigment { rgb <0.6, 0.3, "
             "0.2> } finish { diffuse 0.5 reflection 0.6 } } } "
             "face_indices { 2, <0, 1, 2>, 0, 0, 1, <0, 2, 3>, 0, 1, 1 } }"},
        {"sky over a yard",
         "plane { y, 0 pigment { rgb 0.6 } } box { <-1, 0, 0>, <0, 2, 1> pigment { rgb 0.8 } }"
         "sky_sphere { pigment { rgb <0.1, 0.15, 0.3> } }"},
        {"fog", hollow_room + "fog { distance 4 rgb <0.1, 0.2, 0.3> }"},
        {"smoke",
         hollow_room +
             "media { scattering { 1, 0.08 } absorption <0.02, 0.05, 0.1> density { bozo } }"},
        {"a flame and a cloud in a box",
         hollow_room +
             "sphere { <1.4, 0.7, 0>, 0.6 hollow pigment { rgbt 1 } interior { media { emission "
             "<3, 2, 1> } luminaire } }"
             "box { <-2.8, 1, 0.5>, <0, 2.2, 2.5> hollow pigment { rgbt 1 } interior { media { "
             "scattering { 1, 0.5 } } } }"},
    };
    for (const Row& row : rows) check_same(row.name, lamps_in_room + row.scene, row.generations);
}

TEST_CASE("reflected luminaires light media, and media scatter light as path tracing finds it",
          "[transport]") {
    struct Row {
        const char* name;
        std::string scene;
        std::uint32_t generations = 15;
    };
    const auto fog = [](const std::string& scattering) {
        return hollow_room + lamps_in_room + "media { scattering { " + scattering + " } }";
    };
    const std::string cloud_box =
        "box { <-2.8, 0.1, 0.5>, <2.5, 2.2, 2.5> hollow pigment { rgbt 1 } finish { diffuse 0 } "
        "interior { media { ";
    const Row rows[] = {
        {"fog of all orders", fog("1, 0.15 multiple")},
        {"coloured fog", fog("1, rgb <0.05, 0.2, 0.4> multiple"), 45},
        {"fog that absorbs", hollow_room + lamps_in_room +
                                 "media { absorption <0.1, 0.02, 0.05> scattering { 1, 0.1 "
                                 "multiple } }"},
        {"haze", fog("2, 0.02")},
        {"murk of all orders", fog("3, 0.1 multiple"), 30},
        {"air", fog("4, rgb <0.05, 0.08, 0.12> multiple")},
        {"forward", fog("5, 0.15 eccentricity 0.6 multiple")},
        {"backward, once", fog("5, 0.04 eccentricity -0.4")},
        {"once and repeatedly", hollow_room + lamps_in_room +
                                    "media { scattering { 1, 0.02 } } media { scattering { 5, 0.1 "
                                    "eccentricity 0.5 multiple } }"},
        {"smoke with patterns",
         hollow_room + lamps_in_room + "media { scattering { 1, 0.2 multiple } density { bozo } }"},
        {"fog that glows a little", hollow_room + lamps_in_room +
                                        "media { scattering { 1, 0.1 multiple } emission <0.02, "
                                        "0.01, 0.03> }"},
        {"a cloud in a box",
         hollow_room + lamps_in_room + cloud_box + "scattering { 1, 0.4 multiple } } } }", 30},
        {"a glowing cloud and black walls",
         "box { <-3, 0, -3>, <3, 3, 3> hollow pigment { rgb 0 } }" + cloud_box +
             "scattering { 1, 0.3 multiple } emission 1 } luminaire } } media { scattering { 1, "
             "0.05 multiple } }",
         90},
        {"highlights and a mirror in fog",
         fog("1, 0.1 multiple") +
             "sphere { <1.2, 0.5, 0>, 0.5 pigment { rgb 0.6 } finish { specular 0.4 roughness "
             "0.05 } } box { <2.8, 0.5, -2>, <2.9, 2.5, 2> pigment { rgb 0.2 } finish { "
             "reflection 0.7 } }",
         90},
        {"a source in fog", hollow_room + "light_source { <1, 2, -1>, 1 } media { scattering { 5, "
                                          "0.1 eccentricity 0.4 multiple } }"},
        {"a source without interaction and one without attenuation in fog",
         hollow_room + "light_source { <1, 2, -1>, 0.7 media_interaction off } light_source { <-1, "
                       "2, -1>, 0.7 media_attenuation off } media { scattering { 1, 0.1 multiple } "
                       "}"},
        {"an area light in fog", hollow_room + "light_source { <1.2, 2.9, -1>, 1 area_light x, z, "
                                               "4, 4 } media { scattering { 1, 0.1 multiple } }"},
        {"a cloud under the sky",
         "plane { y, 0 pigment { rgb 0.6 } } sky_sphere { pigment { gradient y color_map { [0 rgb "
         "<0.9, 0.7, 0.5>] [1 rgb <0.2, 0.4, 0.9>] } } luminaire }" +
             cloud_box + "scattering { 1, 0.3 multiple } } } }",
         30},
        {"fog beside fog of the old kind",
         fog("1, 0.1 multiple") + "fog { distance 6 rgb <0.1, 0.2, 0.3> }"},
        {"fog and photons",
         fog("1, 0.05 multiple") +
             "global_settings { photons { count 3000 media 10 } } light_source { <1, 2.5, -1>, 1 } "
             "sphere { <0.9, 1.2, -0.8>, 0.5 pigment { rgbt <0.9, 1, 0.9, 0.95> } interior { ior "
             "1.5 } photons { target refraction on } }",
         200},
    };
    for (const Row& row : rows) check_same(row.name, row.scene, row.generations);
}

TEST_CASE("reflected light of sources and of the sky is what path tracing gives", "[transport]") {
    struct Row {
        const char* name;
        std::string scene;
        std::uint32_t generations = 60;
    };
    const std::string yard =
        "plane { y, 0 pigment { rgb 0.6 } } box { <-1, 0, 0>, <0, 2, 1> pigment { rgb <0.8, 0.6, "
        "0.4> } } box { <1.5, 0, -1>, <1.7, 3, 3> pigment { rgb 0.8 } } ";
    const std::string open_room =
        "difference { box { <-3.2, -0.2, -3.2>, <3.2, 3.2, 3.2> } box { <-3, 0, -3>, <3, 3, 3> } "
        "box { <2, 0.5, -1.5>, <4, 2.8, 1.5> } pigment { rgb <0.8, 0.7, 0.6> } } "
        "box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <0.3, 0.4, 0.8> } } ";
    const Row rows[] = {
        {"a point and a lamp", bare_room + lamps_in_room + "light_source { <1, 2, -1>, 1 }"},
        {"points that fade, one of them dim",
         bare_room + "light_source { <1, 2.9, -1>, <1, 2, 3> fade_distance 0.5 fade_power 2 } "
                     "light_source { <-2, 1, -1>, 0.02 }"},
        {"a spot and a cylinder",
         bare_room +
             "light_source { <1, 2.8, -1>, 4 spotlight point_at <-1, 0, 1> radius 10 falloff 25 } "
             "light_source { <-2, 2.8, -1>, 3 cylinder point_at <-2, 0, -0.9> radius 0.3 falloff "
             "0.6 }"},
        {"an area light with a grid, by itself and as area_illumination",
         bare_room + "light_source { <1.2, 2.9, -1>, 1 area_light x, z, 4, 4 jitter } "
                     "light_source { <-1.5, 1.9, -1>, 0.5 area_light y, 2*z, 3, 5 "
                     "area_illumination }"},
        {"a round area light that turns to what it lights",
         bare_room + "light_source { <1.2, 2, -1>, 1 area_light x, y, 5, 5 circular orient } "
                     "box { <0.5, 1.2, -1.4>, <1.9, 1.25, -0.6> pigment { rgb 0.5 } }"},
        {"parallel light through a window",
         open_room + "light_source { <30, 20, -5>, 2 parallel point_at 0 }"},
        {"a distant point through a window", open_room + "light_source { <3000, 2000, -500>, 2 }"},
        {"light that casts no shadow and light of a group",
         bare_room + "light_source { <1, 5, -1>, 0.5 shadowless } "
                     "light_group { light_source { <-1, 2, -1>, 1 } sphere { <1.5, 0.8, 0.5>, 0.6 "
                     "pigment { rgb 0.8 } } global_lights on }"},
        {"a lamp that looks like something, and panes",
         bare_room +
             "light_source { <1, 2, -1>, 1 looks_like { sphere { 0, 0.2 pigment { rgb 1 } finish { "
             "emission 1 diffuse 0 } } } } "
             "box { <-3, 1.5, -0.1>, <3, 1.6, 3> pigment { rgbt <0.5, 0.5, 0.9, 0.6> } } "
             "disc { <0, 1.5, 1.5>, z, 1 pigment { rgb 0.8 } finish { diffuse 0.4, 0.4 } }"},
        {"light through a window of its own",
         bare_room + "light_source { <1, 2.8, -1>, 2 projected_through { disc { <1, 1.5, -1>, y, "
                     "0.5 } } }",
         270},  // few light paths pass it
        {"many sources",
         bare_room + "#for (I, 0, 149) light_source { <mod(I, 15) * 0.35 - 2.5, 2.5, floor(I / 15) "
                     "* 0.5 - 2.3>, 0.012 } #end"},
        {"fog and a source", hollow_room +
                                 "light_source { <1, 2, -1>, 1 media_attenuation on } fog { "
                                 "distance 4 rgb <0.1, 0.2, 0.3> }"},
        {"photons through a glass and from a mirror",
         bare_room + lamps_in_room +
             "light_source { <1, 2.5, -1>, 1 } global_settings { photons { count 3000 } } "
             "sphere { <0.9, 1.2, -0.8>, 0.5 pigment { rgbt <0.9, 1, 0.9, 0.95> } interior { ior "
             "1.5 } photons { target refraction on reflection on } } "
             "box { <2.8, 0.5, -2>, <2.9, 2.5, 2> pigment { rgb 0.2 } finish { reflection 0.8 } "
             "photons { target reflection on } } "
             "box { <-2.5, 0, -2>, <-1.5, 0.5, 1> pigment { rgb 0.7 } finish { phong 0.5 } photons "
             "{ "
             "collect off } }",
         200},
        {"a sky that is a luminaire over a yard",
         yard + "sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [1 rgb "
                "<0.2, 0.4, 0.9>] } } luminaire }"},
        {"a sky through a window, with a lamp",
         lamps_in_room + open_room + "sky_sphere { pigment { rgb <2, 3, 5> } luminaire }", 200},
        {"daylight with its sun", open_room + "sky_luminance { clear sun <35, 90> }", 120},
    };
    for (const Row& row : rows) check_same(row.name, row.scene, row.generations);
}

TEST_CASE("a closed room that glows everywhere is as bright with reflected luminaires",
          "[transport]") {
    for (const int bounces : {1, 3}) {
        // The last reflection is that of light directly from the walls.
        double expected = 0, power = 1;
        for (int i = 0; i <= bounces + 1; ++i, power *= 0.5) expected += power;
        const Estimate found = estimate(
            with_reflected(500, bounces) +
                "sphere { <0, 1, 0>, 3 inverse pigment { rgb 0.5 } finish { emission 2 } }",
            60, {Vec3(0.3, 0.2, 0.1), unit(Vec3(1, 2, 3))});
        CAPTURE(bounces);
        CHECK(found.mean.r == Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("reflected light over an endless plane is as quiet as over a wide floor",
          "[transport][statistics]") {
    // Some light is reflected far away, which makes the cube of the light sampler's cells huge.
    const auto scene = [](const std::string& floor, int luminaires) {
        return "#version 3.7; global_settings { integrator { path_traced { bounces 1 "
               "reflected_luminaires " +
               std::to_string(luminaires) +
               " } } } #default { finish { ambient 0 diffuse 0.8 } pigment { rgb 0.7 } } camera { "
               "location <0, 3, -6> } sphere { y, 1 } sphere { <2, 4, -2>, 0.3 finish { diffuse 0 "
               "emission 5 } } " +
               floor;
    };
    const std::string plane = "plane { y, 0 }", wide = "box { <-60, -1, -60>, <60, 0, 60> }";
    double of_plane = 0, of_wide = 0;
    for (const Vec3& towards :
         {Vec3(0.9, 1, -0.4), Vec3(-0.9, 1, -0.4), Vec3(0.8, 0.5, -0.3), Vec3(0, 1, -1)}) {
        const Vec3 from(0, 3, -6);
        const Ray ray{from, unit(towards - from)};
        const Estimate endless = estimate(scene(plane, 600), 150, ray),
                       bounded = estimate(scene(wide, 600), 150, ray),
                       by_paths = estimate(scene(plane, 0), 400, ray);
        CAPTURE(towards.x, endless.mean.r, by_paths.mean.r);
        CHECK(std::abs(endless.mean.r - by_paths.mean.r) <
              4.5 * std::hypot(endless.deviation.r, by_paths.deviation.r));
        of_plane += endless.deviation.r * endless.deviation.r;
        of_wide += bounded.deviation.r * bounded.deviation.r;
    }
    CHECK(of_plane < 4 * of_wide);
}

TEST_CASE("each picture of a room under the sky is as bright with few light paths",
          "[transport][statistics]") {
    // Far ground is lit by rays that are rare, and stand for much light.
    const auto scene = [](int luminaires) {
        return with_reflected(luminaires, 4) +
               "camera { location <0.6, 1.6, 0.5> look_at <2.4, 1.1, 3> } difference { box { "
               "<-0.2, "
               "-0.2, -0.2>, <4.2, 3.2, 5.2> } box { <0, 0, 0>, <4, 3, 5> } box { <3.9, 0.9, 1.5>, "
               "<4.3, 2.2, 3> } pigment { rgb 0.72 } } plane { y, -0.2 pigment { rgb 0.3 } } "
               "sky_sphere { pigment { rgb 4 } luminaire }";
    };
    // Green of some places, by the light paths of six generations.
    const auto brightness = [](Integrator& integrator, std::uint32_t picture) {
        constexpr std::uint32_t generations = 6, served = 4, places = 16;
        double sum = 0;
        for (std::uint32_t i = 0; i < generations * served; ++i)
            for (std::uint32_t place = 0; place < places; ++place) {
                const Vec3 from(0.6, 1.6, 0.5),
                    to(0.3 + 1.1 * (place % 4), 0.2 + 0.8 * (place / 4), 5);
                sum += integrator
                           .radiance({from, unit(to - from)},
                                     {place, picture * generations * served + i, 0, 0})
                           .g;
            }
        return sum / (generations * served * places);
    };
    constexpr std::uint32_t pictures = 64;
    struct Found {
        double mean = 0, squares = 0, greatest = 0;
        double deviation() const { return std::sqrt((squares - mean * mean) / pictures); }
    };
    const auto found = [&](int luminaires) {
        const Shot shot = shot_of(scene(luminaires));
        Integrator integrator(shot, {});
        Found all;
        for (std::uint32_t i = 0; i < pictures; ++i) {
            const double one = brightness(integrator, i);
            all.mean += one / pictures;
            all.squares += one * one / pictures;
            all.greatest = std::fmax(all.greatest, one);
        }
        return all;
    };
    const Found few = found(200), by_paths = found(0);
    CAPTURE(few.mean, few.deviation(), few.greatest, by_paths.mean, by_paths.deviation());
    CHECK(std::abs(few.mean - by_paths.mean) <
          4 * std::hypot(few.deviation(), by_paths.deviation()));
    CHECK(few.deviation() < 1.5 * by_paths.deviation());
    CHECK(few.greatest < 2.2 * few.mean);
}

TEST_CASE("light that endless air scatters is as bright and as quiet with reflected luminaires",
          "[transport][statistics]") {
    // A source lights all of the air, whose light the air itself keeps from the camera.
    const auto scene = [](int luminaires) {
        return "#version 3.7; global_settings { integrator { path_traced { bounces 1 "
               "reflected_luminaires " +
               std::to_string(luminaires) +
               " } } } camera { location <0, 2, -5> } light_source { <3000, 5000, -4000>, 1 "
               "parallel point_at 0 } media { scattering { 1, 0.08 multiple } }";
    };
    const Ray ray{Vec3(0, 2, -5), unit(Vec3(0.1, -0.3, 1))};
    const Estimate lit = estimate(scene(3000), 300, ray), by_paths = estimate(scene(0), 600, ray);
    CAPTURE(lit.mean.r, lit.deviation.r, by_paths.mean.r, by_paths.deviation.r);
    CHECK(std::abs(lit.mean.r - 0.5) < 4.5 * lit.deviation.r);
    CHECK(std::abs(by_paths.mean.r - 0.5) < 4.5 * by_paths.deviation.r + 1e-9);
    CHECK(lit.deviation.r < 0.02);
}

}  // namespace candelabra
