// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/direct_light.h"

#include "support/lit.h"
#include "support/means.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a point light gives POV-Ray's colour", "[render]") {
    const Shot shot = shot_of(R"(
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 0.5 } }
        light_source { <0, 4, 3>, rgb 2 }
        sphere { <0, 8, 6>, 1 }
    )");
    CHECK(mean_light(shot, 1, 1) == Approx(0.8 * 0.5 * 2 * 0.8));
}

TEST_CASE("light of each kind adds up with the others at every vertex", "[transport]") {
    const std::string source = "light_source { <3, 5, -4>, rgb 1.5 } ";
    // So small that it hides nothing of the sky.
    const std::string lamp =
        "sphere { <-4, 4, -4>, 0.02 pigment { rgb 1 } finish { diffuse 0 emission 40000 } } ";
    const std::string sky =
        "sky_sphere { pigment { gradient y color_map { [0.5 rgb 0.1] [0.9 rgb 2] } scale 2 "
        "translate -1 } luminaire } ";
    const std::pair<const char*, const char*> receivers[] = {
        {"diffuse", "sphere { 0, 1 pigment { rgb 0.8 } finish { diffuse 0.9 } }"},
        {"highlights", "sphere { 0, 1 pigment { rgb 0.8 } finish { specular 0.4 phong 0.3 } }"},
        {"facets",
         "sphere { 0, 1 pigment { rgb 0.8 } finish { microfacet { roughness 0.6 coat 1 } } }"},
        {"media",
         "sphere { 0, 1 hollow pigment { rgbt 1 } finish { diffuse 0 } interior { media { "
         "scattering { 1, 0.5 } } } } "},
        {"media outside",
         "media { scattering { 5, 0.05 eccentricity 0.4 } } "
         "plane { -z, -3 pigment { rgb 0 } finish { diffuse 0 } } "},
        {"subsurface",
         "sphere { 0, 1 pigment { rgb 0.8 } finish { diffuse 0.7 subsurface { translucency 0.3 } } "
         "interior { ior 1.4 } } "}};
    const std::string methods[] = {
        "", "light_sampler { light_bvh { mis } }", "integrator { path_traced { bounces 0 } }",
        "integrator { path_traced { bounces 2 reflected_luminaires 0 } }"};
    const Ray ray{Vec3(0.2, 0.3, -5), Vec3(0, 0, 1)};
    for (const auto& [name, receiver] : receivers)
        for (const std::string& method : methods) {
            const std::string before =
                "#version 3.7; #default { finish { ambient 0 } } global_settings { mm_per_unit 10 "
                "subsurface { samples 20, 10 } " +
                method + " } " + receiver;
            const auto seen = [&](const std::string& lights) {
                return mean_seen(before + lights, ray, 1500);
            };
            const Mean each[] = {seen(source), seen(lamp), seen(sky)};
            CAPTURE(name, method);
            CHECK(agree(each[0] + each[1], seen(source + lamp)));
            CHECK(agree(each[0] + each[2], seen(source + sky)));
            CHECK(agree(each[1] + each[2], seen(lamp + sky)));
            CHECK(agree(each[0] + each[1] + each[2], seen(source + lamp + sky)));
        }
}

}  // namespace candelabra
