// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_left.h"

#include "support/means.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

const char* const clear = " pigment { rgbt 1 } hollow interior { media { absorption 0.5 } } }";

double left(const World& world, double distance, AirOnWay air = AirOnWay::followed) {
    const Ray ray{Vec3(0, 0, -5), Vec3(0, 0, 1)};
    return light_left(world, {.ray = ray, .distance = distance, .air = air}, {}).r;
}

}  // namespace

TEST_CASE("media dim light on the parts of its way that they fill", "[transport]") {
    const std::string box = "box { <-9, -9, 0>, <9, 9, 2>";
    const SharedWorld slab = world_of(box + clear);
    CHECK(left(*slab, 20) == Approx(std::exp(-1)));
    CHECK(left(*slab, 6) == Approx(std::exp(-0.5)));
    CHECK(left(*slab, 4) == 1);
    CHECK(left(*world_of(box + " no_shadow" + clear), 20) == 1);
    const SharedWorld two = world_of(box + clear + "sphere { <0, 0, 2>, 1" + clear);
    CHECK(left(*two, 20) == Approx(std::exp(-2)));
    const SharedWorld solid =
        world_of(box + " pigment { rgbt 1 } interior { media { absorption 0.5 } } }");
    CHECK(left(*solid, 20) == 1);
}

TEST_CASE("media outside of solids dim the whole way of a light source that says so",
          "[transport]") {
    const SharedWorld world = world_of("media { absorption 0.1 } box { -1, 1 pigment { rgbt 1 } }");
    CHECK(left(*world, 10, AirOnWay::throughout) == Approx(std::exp(-1)));
    CHECK(left(*world, 10, AirOnWay::in_solids) == 1);
    CHECK(left(*world, 10, AirOnWay::none) == 1);
    CHECK(left(*world, 1e20, AirOnWay::throughout) == 0);
}

TEST_CASE("what is left where no surface lies on the way is that of the walk, to the bit",
          "[transport]") {
    const SharedWorld world = world_of(
        "#version 3.7; media { absorption <0.1, 0.2, 0.3> scattering { 1, 0.05 } density { bozo } "
        "} "
        "fog { rgb 1 distance 20 } sphere { 0, 50 hollow pigment { rgbt 1 } interior { media { "
        "absorption 0.02 density { granite } } } }");
    const PrimitiveIndex around[] = {0};
    for (const AirOnWay air :
         {AirOnWay::followed, AirOnWay::throughout, AirOnWay::in_solids, AirOnWay::none})
        for (std::uint32_t sample = 0; sample < 16; ++sample) {
            Key key;
            key.sample = sample;
            const WayOfLight way{.ray = {Vec3(0.5 * sample, 0, -5), unit(Vec3(1, 2, 3))},
                                 .distance = 1.0 + sample,
                                 .around = around,
                                 .air = air};
            const Rgb left = light_left(*world, way, key);
            CHECK(left_on_free_way(*world, way, key) == left);
            CHECK((left == Rgb(1)) == (air == AirOnWay::none));
        }
}

TEST_CASE("air dims light on its way as it dims a ray that follows the way back", "[transport]") {
    struct Air {
        const char* name;
        std::string words;
    };
    const Air airs[] = {
        {"fog", "fog { rgb 0 distance 4 }"},
        {"white fog", "fog { rgb 1 distance 6 }"},
        {"clear fog", "fog { rgbft <0.8, 0.5, 0.2, 0.5, 0.1> distance 3 }"},
        {"ground fog", "fog { rgb 0.2 distance 2 fog_type 2 fog_offset 0.5 fog_alt 0.7 }"},
        {"turbid fog", "fog { rgb 0 distance 3 turbulence 0.8 turb_depth 0.6 }"},
        {"rainbow",
         "rainbow { direction <0, 1, 0> angle 20 width 30 distance 5 color_map { [0 rgb "
         "<0.5, 0.1, 0>] [1 rgb <0, 0.2, 0.4>] } }"},
        {"medium", "media { absorption 0.2 }"},
        {"patchy medium", "media { absorption 0.4 density { bozo scale 0.7 } }"},
        {"fog and medium", "fog { rgb 0 distance 9 } media { absorption 0.1 }"}};
    const std::string clear = " pigment { rgbt 1 } finish { diffuse 0 } ";
    const std::pair<const char*, std::string> between[] = {
        {"nothing", ""},
        {"a solid", "box { <-50, 1, -50>, <50, 2, 50>" + clear + "} "},
        {"a hollow solid", "box { <-50, 1, -50>, <50, 2, 50>" + clear + "hollow } "},
        {"a solid with media", "box { <-50, 1, -50>, <50, 2, 50>" + clear +
                                   "hollow interior { media { absorption 0.3 } } } "},
        {"the floor in a solid", "sphere { 0, 1.5" + clear + "} "}};
    const std::pair<const char*, std::string> lights[] = {
        {"ball", "sphere { 4*y, 1.5 pigment { rgb 1 } finish { emission 4 diffuse 0"},
        {"panel", "box { <-2, 4, -2>, <2, 4.1, 2> pigment { rgb 1 } finish { emission 4 diffuse 0"},
        {"sky", "sky_sphere { pigment { rgb 1 }"}};
    const Ray ray{Vec3(0, 0.3, -0.3), unit(Vec3(0, -1, 1))};
    for (const Air& air : airs)
        for (const auto& [what, solid] : between)
            for (const auto& [kind, light] : lights) {
                const bool sky = light.starts_with("sky");
                const std::string scene =
                    "plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } } " + solid +
                    air.words + light;
                const auto seen = [&](const std::string& integrator, const std::string& words) {
                    return mean_seen(
                        "#version 3.7; #default { finish { ambient 0 } } "
                        "global_settings { integrator { " +
                            integrator + " } } " + scene + words,
                        ray, 1500);
                };
                const Mean met =
                               seen("path_traced { bounces 1 }", sky ? " }" : " no_luminaire } }"),
                           sampled =
                               seen("path_traced { bounces 1 }", sky ? " luminaire }" : " } }"),
                           without_bounces =
                               seen("path_traced { bounces 0 }", sky ? " luminaire }" : " } }"),
                           by_default = seen("pov_ray", sky ? " luminaire }" : " } }");
                CAPTURE(air.name, what, kind, met.value, sampled.value, by_default.value);
                CHECK(agree(met, sampled));
                CHECK(agree(without_bounces, by_default));
            }
}

TEST_CASE("air dims what radiosity gathers of luminaires only if that is asked for",
          "[transport]") {
    const auto seen = [](const std::string& words, const std::string& finish) {
        return mean_seen(
            "#version 3.7; #default { finish { ambient 0 } } global_settings { radiosity "
            "{ recursion_limit 1 " +
                words +
                " } } fog { rgb 0 distance 4 } plane { y, 0 pigment { rgb 0.7 } finish { "
                "diffuse 0.8 } } sphere { 4*y, 1.5 pigment { rgb 1 } finish { emission "
                "4 diffuse 0 " +
                finish + " } }",
            {Vec3(0, 0.3, -0.3), unit(Vec3(0, -1, 1))}, 8000);
    };
    CHECK(agree(seen("", ""), seen("", "no_luminaire")));
    CHECK(agree(seen("media on", ""), seen("media on", "no_luminaire")));
    CHECK_FALSE(agree(seen("", ""), seen("media on", "")));
}

}  // namespace candelabra
