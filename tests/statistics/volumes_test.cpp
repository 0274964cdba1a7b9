// SPDX-License-Identifier: GPL-3.0-or-later
// Media that are luminaires give the light that closed forms say, and the light that paths find
// which meet them by chance, whatever the light strategy.

#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

const std::string clear_hollow = " pigment { rgbt 1 } finish { ambient 0 diffuse 0 } hollow ";

struct Found {
    Rgb mean, deviation;  ///< of the mean
};

Found seen(const std::string& script, std::uint32_t count, const Ray& ray) {
    const Shot shot = shot_of("#version 3.7; " + script);
    Integrator integrator(shot, {});
    Rgb sum(0), squares(0);
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        const Rgb one = integrator.radiance(ray, key);
        sum += one;
        squares += one * one;
    }
    const Rgb mean = sum / static_cast<double>(count);
    return {mean, sqrt(max(squares / static_cast<double>(count) - mean * mean, Rgb(0)) /
                       static_cast<double>(count))};
}

void check_alike(const Found& a, const Found& b) {
    for (int i = 0; i < 3; ++i) {
        const double deviation = std::hypot(a.deviation[i], b.deviation[i]);
        CHECK(std::abs(a.mean[i] - b.mean[i]) <= 4.5 * deviation + 1e-9);
    }
}

std::string with(const std::string& sampler, const std::string& integrator) {
    return "global_settings { max_trace_level 12 light_sampler { " + sampler + " } integrator { " +
           integrator + " } } ";
}

}  // namespace

TEST_CASE("a ball of glowing gas lights by the square law", "[statistics]") {
    // Every part of it emits as much to all sides, so the ball as a whole obeys the law exactly:
    // volume times emission over squared distance.
    const std::string scene = "sphere { <0, 2, 0>, 1" + clear_hollow +
                              "interior { media { emission <3, 1.5, 0> } luminaire } } "
                              "plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } } ";
    const double square = 4 + 2.25, cosine = 2 / std::sqrt(square), pi = std::acos(-1);
    const double expected = 0.5 / pi * 3 * 4.0 / 3 * pi * cosine / square;
    for (const char* const sampler :
         {"light_octree", "light_octree { alone }", "light_octree { paper }", "light_bvh",
          "light_bvh { mis }", "linear_alpha", "constant_alpha", "every_light"})
        for (const char* const integrator : {"pov_ray", "path_traced { bounces 0 }"}) {
            CAPTURE(sampler, integrator);
            const bool slow = std::string(sampler) == "every_light";
            const Found found = seen(with(sampler, integrator) + scene, slow ? 200 : 4000,
                                     {Vec3(1.5, 1, -8), unit(Vec3(0, -1, 8))});
            CHECK(std::abs(found.mean.r - expected) <= 4.5 * found.deviation.r);
            CHECK(found.deviation.r < 0.05 * expected);
            CHECK(found.mean.g == Approx(found.mean.r / 2));
            CHECK(found.mean.b == 0);
        }
}

TEST_CASE("air is lit by glowing gas as by what is small", "[statistics]") {
    // Light of colour E V / (pi d^2), over half of a line that passes at distance 2.
    const Found found = seen("media { scattering { 1, 1 extinction 0 } } sphere { <2, 0, 0>, 0.05" +
                                 clear_hollow + "interior { media { emission 400 } luminaire } }",
                             20000, {Vec3(0), Vec3(0, 0, 1)});
    const double volume = 4.0 / 3 * std::acos(-1) * 0.05 * 0.05 * 0.05;
    CHECK(found.mean.r == Approx(400 * volume / (2 * 2)).epsilon(0.03));
}

TEST_CASE("in a room full of glowing gas all is as bright", "[statistics]") {
    // The gas by itself has radiance 2 / 0.5, and so have walls that emit what they do not reflect.
    const std::string room =
        "sphere { 0, 2.999" + clear_hollow +
        "interior { media { emission 2 absorption 0.5 } luminaire } } sphere { 0, 3 inverse hollow "
        "pigment { rgb 1 } finish { ambient 0 diffuse 0.5 emission 2 } } ";
    for (const char* const sampler : {"light_octree", "light_bvh { mis }"})
        for (const Vec3& from : {Vec3(0, 0, -2.5), Vec3(0.1, 0.2, 0.3)}) {
            CAPTURE(sampler);
            const Found found = seen(with(sampler, "path_traced { bounces 100 }") + room, 1500,
                                     {from, unit(Vec3(0.2, 0.1, 1))});
            CHECK(std::abs(found.mean.r - 4) <= 4.5 * found.deviation.r);
            CHECK(found.deviation.r < 0.12);
        }
}

TEST_CASE("paths count glowing media once, however they meet them", "[statistics]") {
    // Without the word, paths find the light by chance: by one diffuse bounce more.
    const std::string flame = "sphere { 0, 1 scale <0.8, 1.2, 0.8> translate y" + clear_hollow +
                              "interior { media { emission <4, 2, 1> absorption <0, 0.3, 0.6> "
                              "density { spherical scale <0.8, 1.2, 0.8> translate y } } $ } } ";
    const std::string around =
        "camera { location <0, 3, -6> } #default { finish { ambient 0 diffuse 0.7 } } "
        "plane { y, 0 pigment { rgb 1 } } "
        "box { <-3, 0, 2>, <3, 3, 3> pigment { rgb 1 } finish { microfacet { roughness 0.5 } } } "
        "sphere { <1.6, 0.7, 0>, 0.6 pigment { rgb 0.2 } finish { diffuse 0 reflection 0.9 } } "
        "sphere { <-1.6, 0.7, 0>, 0.6 pigment { rgbt 0.9 } finish { diffuse 0.1 } } ";
    const auto scene = [&](const std::string& integrator, bool luminaire) {
        std::string own = flame;
        own.replace(own.find('$'), 1, luminaire ? "luminaire" : "");
        return with("light_octree", integrator) + own + around;
    };
    const std::vector<Ray> rays = {{Vec3(0, 3, -6), unit(Vec3(-0.2, -2.9, 5))},
                                   {Vec3(0, 1, -6), unit(Vec3(0.1, 0.1, 6))},
                                   {Vec3(0, 1, -6), unit(Vec3(1.5, -0.2, 6))},
                                   {Vec3(-2.4, 1, -6), unit(Vec3(0, 0.8, 8))},
                                   {Vec3(0, 3, -6), unit(Vec3(-1.6, -2.3, 6))}};
    for (const Ray& ray : rays) {
        CAPTURE(ray.direction.x, ray.direction.y);
        check_alike(seen(scene("path_traced { bounces 2 }", true), 2000, ray),
                    seen(scene("path_traced { bounces 3 }", false), 8000, ray));
    }
}

namespace {

/// Checks that a floor below media gets the light that a path finds there by chance; `$` in the
/// script is where `luminaire` may stand.
void check_sampled_as_met(const std::string& script, std::uint32_t count) {
    const auto scene = [&](bool luminaire) {
        std::string own = script;
        for (std::size_t at; (at = own.find('$')) != own.npos;)
            own.replace(at, 1, luminaire ? "luminaire" : "");
        return with("light_octree",
                    luminaire ? "path_traced { bounces 0 }" : "path_traced { bounces 1 }") +
               "camera { location <0, 0.5, -0.5> } "
               "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } " +
               own;
    };
    const Ray ray{Vec3(0, 0.5, -0.5), unit(Vec3(0.1, -0.5, 0.5))};
    CAPTURE(script);
    check_alike(seen(scene(true), count, ray), seen(scene(false), 4 * count, ray));
}

}  // namespace

TEST_CASE("media in a clipped solid light what sees them, whatever clips it", "[statistics]") {
    const std::string shapes[] = {
        "plane { <0.3, 1, 0.2>, 2",
        "sphere { <0.3, 1.6, 0>, 0.6",
        "box { <-0.4, 1, -0.3>, <0.5, 2.1, 0.4>",
        "cylinder { <0, 0, 0.1>, <0, 4, 0.1>, 0.4",
        "cone { <0, 1, 0>, 0.7, <0.2, 3, 0>, 0.1",
        "torus { 0.5, 0.2 rotate 40*x translate 2*y",
        "union { sphere { <-0.3, 1.7, 0>, 0.4 } box { <0, 1, -0.2>, <0.6, 2, 0.2> }",
        "intersection { sphere { 1.7*y, 0.7 } cylinder { <0, 0, 0>, <0, 4, 0>, 0.4 }",
        "sphere { 1.6*y, 0.7 clipped_by { plane { x, 0.1 } }",
        "merge { sphere { <-0.3, 1.7, 0>, 0.4 inverse } box { <0, 1, -0.2>, <0.6, 2, 0.2> }"};
    for (const std::string& shape : shapes)
        for (const char* const side : {" } ", " inverse } "})
            for (const char* const behind :
                 {"", "plane { -y, -4 pigment { rgb 0 } finish { ambient 0 diffuse 0 } } "})
                check_sampled_as_met(std::string(behind) + "sphere { 2*y, 0.8" + clear_hollow +
                                         "interior { media { emission 1 absorption 0.3 } $ } "
                                         "clipped_by { " +
                                         shape + side + "} } ",
                                     600);
}

TEST_CASE("media light through what is open as they are seen", "[statistics]") {
    const std::string gas = clear_hollow + "interior { media { emission 1 absorption 0.3 } $ } } ";
    const std::string wall = "plane { -y, -4 pigment { rgb 0 } finish { ambient 0 diffuse 0 } } ";
    const std::string scenes[] = {
        "cylinder { y, 2*y, 0.7 open" + gas + wall, "cone { y, 0.7, 2*y, 0.2 open" + gas + wall,
        "intersection { union { sphere { <-0.2, 2, 0>, 0.5 } sphere { <0.2, 2, 0>, 0.5 } } "
        "sphere { 2*y, 0.6 }" +
            gas,
        // Two of them, one in the other.
        "sphere { 2*y, 0.8 clipped_by { plane { x, 0 } }" + gas + "sphere { 2*y, 0.5" + gas + wall,
        // Behind clear things that rays pass without leaving them.
        "sphere { 2*y, 0.5" + gas + "disc { y, y, 0.5 pigment { rgbt 1 } finish { diffuse 0 } }",
        "sphere { 2*y, 0.3" + gas +
            "mesh { triangle { <-1, 1, -1>, <1, 1, -1>, <0, 1, 1> } triangle { <-1, 1, -1>, "
            "<1, 1, -1>, <0, 3, 0> } triangle { <1, 1, -1>, <0, 1, 1>, <0, 3, 0> } triangle { "
            "<0, 1, 1>, <-1, 1, -1>, <0, 3, 0> } pigment { rgbt 1 } finish { diffuse 0 } }"};
    for (const std::string& scene : scenes) check_sampled_as_met(scene, 1000);
}

TEST_CASE("a flame that casts no shadow is dimmed by itself, and dims nothing else",
          "[statistics]") {
    const std::string flames[] = {
        "media { emission 1 absorption 1 } $",
        "media { emission 1 absorption 2 density { spherical translate 2*y } } $"};
    for (const std::string& flame : flames)
        for (const char* const shape : {"sphere { 2*y, 0.8", "box { <-0.6, 1, -0.6>, <0.6, 2, 0.6>",
                                        "sphere { 2*y, 0.8 clipped_by { plane { x, 0.2 } }",
                                        "difference { sphere { 2*y, 0.8 } sphere { 2*y, 0.5 }"})
            for (const char* const colour : {"rgbt 1", "rgbft <1, 0.8, 0.5, 0.6, 0>"})
                check_sampled_as_met(std::string(shape) + " no_shadow pigment { " + colour +
                                         " } finish { ambient 0 diffuse 0 } hollow interior { " +
                                         flame + " } } ",
                                     600);
    const auto floor = [](const std::string& flame) {
        return seen(
            with("light_octree", "path_traced { bounces 0 }") +
                "camera { location <0, 0.5, -0.5> } plane { y, 0 pigment { rgb 1 } finish { "
                "ambient 0 diffuse 1 } } sphere { 5*y, 1 pigment { rgb 1 } finish { ambient "
                "0 diffuse 0 emission 5 } } " +
                flame,
            400, {Vec3(0, 0.5, -0.5), unit(Vec3(0.1, -0.5, 0.5))});
    };
    check_alike(floor(""), floor("sphere { 2*y, 0.8 no_shadow" + clear_hollow +
                                 "interior { media { absorption 1 } luminaire } } "));
}

}  // namespace candelabra
