// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of lamp gives the light that paths find by chance, whatever is on the way of its light.

#include "support/means.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct NamedScript {
    const char* name;
    std::string script;
};

/// Scripts of lamps; `$` is where `no_luminaire` may stand, `%` is where `luminaire` may.
std::vector<NamedScript> lamps() {
    const std::string glow = " pigment { rgb 1 } finish { diffuse 0 emission 3 $ } ";
    const std::string half =
        " pigment { rgbt <1, 0.8, 0.6, 0.5> } finish { diffuse 0 emission 3 $ } ";
    return {
        {"sphere", "sphere { 2*y, 0.5" + glow + "} "},
        {"box", "box { <-0.4, 1.6, -0.4>, <0.4, 2.2, 0.4>" + glow + "} "},
        {"triangle", "triangle { <-0.6, 2, -0.5>, <0.7, 2.2, -0.5>, <0, 1.8, 0.7>" + glow + "} "},
        {"torus", "torus { 0.5, 0.15 rotate 30*x translate 2*y" + glow + "} "},
        {"difference",
         "difference { sphere { 2*y, 0.6 } sphere { <0, 1.6, -0.3>, 0.5 }" + glow + "} "},
        {"doubled face",
         "mesh { triangle { <-0.6, 2, -0.5>, <0.7, 2.2, -0.5>, <0, 1.8, 0.7> } triangle { <-0.6, "
         "2, "
         "-0.5>, <0.7, 2.2, -0.5>, <0, 1.8, 0.7> }" +
             glow + "} "},
        {"doubled half-clear face",
         "mesh { triangle { <-0.6, 2, -0.5>, <0.7, 2.2, -0.5>, <0, 1.8, 0.7> } triangle { <-0.6, "
         "2, "
         "-0.5>, <0.7, 2.2, -0.5>, <0, 1.8, 0.7> }" +
             half + "} "},
        {"clipped sphere", "sphere { 2*y, 0.6 clipped_by { plane { y, 1.9 } }" + glow + "} "},
        {"half-clear sphere", "sphere { 2*y, 0.5" + half + "} "},
        {"half-clear box", "box { <-0.4, 1.6, -0.4>, <0.4, 2.2, 0.4>" + half + "} "},
        {"half-clear cylinder", "cylinder { 1.6*y, 2.2*y, 0.4" + half + "} "},
        {"half-clear torus", "torus { 0.5, 0.15 translate 2*y" + half + "} "},
        {"torus without shadow",
         "torus { 0.5, 0.15 rotate 60*x translate 2*y no_shadow" + glow + "} "},
        {"open cylinder without shadow",
         "cylinder { 1.6*y, 2.4*y, 0.4 open no_shadow" + glow + "} "},
        {"inner side",
         "sphere { 2*y, 0.6 clipped_by { plane { y, 2 } } texture { pigment { rgb 1 } "
         "finish { diffuse 0 } } interior_texture {" +
             glow + "} } "},
        {"checker",
         "sphere { 2*y, 0.5 pigment { checker rgb 1 rgbt 1 scale 0.2 } finish { diffuse 0 "
         "emission 3 $ } } "},
        {"layers", "sphere { 2*y, 0.5 texture {" + glow +
                       "} texture { pigment { rgbt <1, 0.5, 0.5, "
                       "0.5> } finish { diffuse 0 } } } "},
        {"flame",
         "sphere { 2*y, 0.6 hollow pigment { rgbt 1 } finish { diffuse 0 } interior { media { "
         "emission 2 absorption 0.5 density { spherical scale 0.6 translate 2*y } } % } } "},
        {"sky",
         "sky_sphere { pigment { gradient y color_map { [0 rgb 0] [0.6 rgb 0] [1 rgb 2] } } % } "},
    };
}

/// Scripts of what is on the way, or around.
std::vector<NamedScript> surroundings() {
    const std::string clear = " pigment { rgbt 1 } finish { diffuse 0 } ";
    const std::string grey = " pigment { rgb 0.5 } finish { diffuse 0.8 } ";
    return {
        {"nothing", ""},
        {"fog", "fog { rgb 0.1 distance 5 } "},
        {"absorbing air", "media { absorption 0.1 } "},
        {"haze", "media { scattering { 1, 0.1 multiple } } "},
        {"clear sheet", "box { <-3, 0.9, -3>, <3, 1.1, 3>" + clear + "} "},
        {"pane",
         "box { <-30, 0.9, -30>, <30, 1.1, 30> pigment { rgbt 1 } finish { diffuse 0 "
         "reflection { 0, 1 fresnel } conserve_energy } } "},
        {"tinted sheet",
         "box { <-3, 0.9, -3>, <3, 1.1, 3> pigment { rgbf <0.9, 0.7, 0.5, 0.8> } "
         "finish { diffuse 0.2 } } "},
        {"lacquered sheet",
         "box { <-30, 0.9, -30>, <30, 1.1, 30> pigment { rgbt 0.9 } finish { "
         "microfacet { roughness 0.3 } } } "},
        {"clipped ball", "sphere { y, 0.8 clipped_by { plane { x, 0 } }" + grey + "} "},
        {"mirror",
         "box { <-3, 0, 1.5>, <3, 3, 1.6> pigment { rgb 0.5 } finish { diffuse 0 reflection "
         "0.8 } } "},
        {"facets",
         "box { <-3, 0, 1.5>, <3, 3, 1.6> pigment { rgb 0.8 } finish { microfacet { "
         "roughness 0.3 metallic 0.5 } } } "},
        {"ball", "sphere { <0.5, 0.5, 0>, 0.4" + grey + "} "},
        {"copies",
         "#declare O = union { sphere { 0, 0.15 } cylinder { -0.3*y, 0, 0.05 }" + grey +
             "} #for (I, 0, 6) object { O translate <0.3*I - 0.9, 0.8, 0.1*I - 0.3> } #end "},
        {"smoke", "sphere { y, 0.6 hollow" + clear + "interior { media { absorption 1 } } } "},
        {"tinted solid", "sphere { y, 0.6" + clear +
                             "interior { fade_distance 0.5 fade_power 1 fade_color rgb 0.5 } } "},
        {"smoke around", "sphere { 2*y, 1.2 hollow" + clear +
                             "interior { media { absorption 0.4 density { bozo scale 0.4 } } } } "},
        {"solid around", "sphere { 2*y, 1.2" + clear + "} "},
    };
}

std::string with_words(std::string script, bool chosen) {
    const auto put = [&](char sign, const std::string& word) {
        for (std::size_t at; (at = script.find(sign)) != script.npos;) script.replace(at, 1, word);
    };
    put('$', chosen ? "" : "no_luminaire");
    put('%', chosen ? "luminaire" : "");
    return script;
}

}  // namespace

TEST_CASE("every kind of lamp gives the light that is found by chance, by any way",
          "[statistics]") {
    const Ray ray{Vec3(0.3, 0.5, -0.6), unit(Vec3(-0.1, -0.5, 0.5))};
    for (const NamedScript& lamp : lamps())
        for (const NamedScript& around : surroundings()) {
            const auto mean = [&](bool chosen, std::uint32_t count) {
                return mean_seen(
                    "#version 3.7; #default { finish { ambient 0 } } global_settings { "
                    "max_trace_level 20 integrator { path_traced { reflected_luminaires 0 "
                    "bounces " +
                        std::string(chosen ? "1" : "2") +
                        " } } } plane { y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 } } " +
                        with_words(lamp.script, chosen) + around.script,
                    ray, count);
            };
            const Mean chosen = mean(true, 600), met = mean(false, 2400);
            CAPTURE(lamp.name, around.name, chosen.value, chosen.error, met.value, met.error);
            CHECK(agree(chosen, met, 0.01));
        }
}

}  // namespace candelabra
