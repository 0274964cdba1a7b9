// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/participating_media.h"

#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Mean of many samples of one ray.
Vec3 seen_in_air(const std::string& script, std::uint32_t count, const Ray& ray) {
    const World world = world_of("#version 3.7; " + script);
    Integrator integrator(world, {});
    Vec3 sum(0);
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) sum += integrator.radiance(ray, key);
    return sum / static_cast<double>(count);
}

const Ray along_z{Vec3(0, 0, -5), Vec3(0, 0, 1)};

}  // namespace

TEST_CASE("a luminaire lights the air as its light integrated over the ray", "[transport]") {
    // A small sphere of radiance L and radius r gives light of colour L r^2 / d^2 at distance d:
    // beside an infinite ray at distance h that is L r^2 pi / (2 h), and half of that on half of
    // the ray.
    const char* const lamps[] = {"", "global_settings { light_sampler { light_bvh } } ",
                                 "global_settings { light_sampler { light_bvh { mis } } } ",
                                 "global_settings { light_sampler { every_light } } ",
                                 "global_settings { light_sampler { light_octree { paper } } } "};
    for (const char* const sampler : lamps) {
        const Vec3 found = seen_in_air(
            std::string(sampler) +
                "media { scattering { 1, rgb <1, 0.5, 0> extinction 0 } } sphere { <2, 0, 0>, 0.05 "
                "pigment { rgb 1 } finish { emission 40 } }",
            40000, {Vec3(0), Vec3(0, 0, 1)});
        const double expected = 40 * 0.05 * 0.05 * std::acos(-1) / 2 / 2;
        CAPTURE(sampler);
        CHECK(found.x == Approx(expected).epsilon(0.03));
        CHECK(found.y == Approx(expected / 2).epsilon(0.03));
        CHECK(found.z == 0);
    }
}

TEST_CASE("light in air is dimmed on both ways", "[transport]") {
    // A bright lamp far away, seen from the side: light of colour 1 in the slab.
    const std::string slab =
        "camera { location -20*z } box { <-2, -9, -9>, <9, 9, 9> pigment { rgbt 1 } finish { "
        "ambient 0 diffuse 0 } hollow "
        "interior { media { scattering { 1, 0.3 extinction 1 } } } } ";
    const std::string lamp =
        "sphere { <-10002, 0, 0>, 100 pigment { rgb 1 } finish { emission 10000 } }";
    const double expected = 0.3 * std::exp(-0.6) * (1 - std::exp(-0.3 * 18)) / 0.3;
    for (const std::string sampler : {"", "light_bvh", "light_bvh { exponential }"}) {
        CAPTURE(sampler);
        const std::string chosen =
            sampler.empty() ? "" : "global_settings { light_sampler { " + sampler + " } } ";
        const Vec3 found =
            seen_in_air(chosen + slab + lamp, 20000, {Vec3(0, 0, -20), Vec3(0, 0, 1)});
        CHECK(found.x == Approx(expected).epsilon(0.02));
    }
}

TEST_CASE("integrators see the same light in air", "[transport]") {
    const std::string scene =
        "media { scattering { 5, 0.05 eccentricity 0.4 } density { bozo scale 2 } } "
        "light_source { <3, 4, 1>, rgb 1 media_attenuation on } "
        "box { <-3, -2, -1>, <-2, 2, 1> pigment { rgb 1 } finish { emission 3 diffuse 0 } } "
        "plane { -z, -6 pigment { rgb 0.5 } finish { ambient 0 } } ";
    const Vec3 plain = seen_in_air(scene, 20000, along_z);
    const Vec3 traced = seen_in_air(
        "global_settings { integrator { path_traced { bounces 0 } } } " + scene, 20000, along_z);
    for (int i = 0; i < 3; ++i) CHECK(traced[i] == Approx(plain[i]).epsilon(0.02));
}

TEST_CASE("multiple scattering makes no energy", "[transport]") {
    // In a closed room that glows everywhere, scattering without loss changes nothing.
    for (const char* const extinction : {"1", "3"}) {
        const Vec3 found = seen_in_air(
            std::string("global_settings { max_trace_level 12 integrator { path_traced { bounces "
                        "200 } } } media { scattering { 5, 0.4 eccentricity 0.5 multiple "
                        "extinction ") +
                extinction +
                " } } sphere { 0, 5 inverse hollow pigment { rgb 1 } finish { ambient "
                "0 diffuse 0 emission 2 no_luminaire } }",
            4000, {Vec3(0, 0, -4), Vec3(0, 0, 1)});
        if (*extinction == '1')
            CHECK(found.x == Approx(2).epsilon(0.02));
        else
            CHECK(found.x < 1.5);
    }
}

TEST_CASE("media are not there for low quality, nor beyond what the scene has", "[transport]") {
    const World world = world_of(
        "#version 3.7; sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission 1 } } "
        "}");
    CHECK(world.has_media());
    CHECK_FALSE(world.left_to_chance());
    ParticipatingMedia media(world);
    DirectLight light(world, 1);
    LightLedger ledger;
    PathState path;
    path.ray = along_z;
    CHECK(media.along(path, 3, light, ledger).added == Vec3(0));
    path.media.push_back(0);
    CHECK(media.along(path, 3, light, ledger).added == Vec3(3));
    CHECK(media.along(path, std::numeric_limits<double>::infinity(), light, ledger).added ==
          Vec3(0));
}

}  // namespace candelabra
