// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/participating_media.h"

#include "base/cosine_direction.h"
#include "support/draw.h"
#include "support/means.h"
#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// Mean of many samples of one ray.
Rgb seen_in_air(const std::string& script, std::uint32_t count, const Ray& ray) {
    const Shot shot = shot_of("#version 3.7; " + script);
    Integrator integrator(shot, {});
    Rgb sum(0);
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
        const Rgb found = seen_in_air(
            std::string(sampler) +
                "media { scattering { 1, rgb <1, 0.5, 0> extinction 0 } } sphere { <2, 0, 0>, 0.05 "
                "pigment { rgb 1 } finish { emission 40 } }",
            40000, {Vec3(0), Vec3(0, 0, 1)});
        const double expected = 40 * 0.05 * 0.05 * std::acos(-1) / 2 / 2;
        CAPTURE(sampler);
        CHECK(found.r == Approx(expected).epsilon(0.03));
        CHECK(found.g == Approx(expected / 2).epsilon(0.03));
        CHECK(found.b == 0);
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
        const Rgb found =
            seen_in_air(chosen + slab + lamp, 20000, {Vec3(0, 0, -20), Vec3(0, 0, 1)});
        CHECK(found.r == Approx(expected).epsilon(0.02));
    }
}

TEST_CASE("integrators see the same light in air", "[transport]") {
    const std::string scene =
        "media { scattering { 5, 0.05 eccentricity 0.4 } density { bozo scale 2 } } "
        "light_source { <3, 4, 1>, rgb 1 media_attenuation on } "
        "box { <-3, -2, -1>, <-2, 2, 1> pigment { rgb 1 } finish { emission 3 diffuse 0 } } "
        "plane { -z, -6 pigment { rgb 0.5 } finish { ambient 0 } } ";
    const Rgb plain = seen_in_air(scene, 20000, along_z);
    const Rgb traced = seen_in_air(
        "global_settings { integrator { path_traced { bounces 0 } } } " + scene, 20000, along_z);
    for (int i = 0; i < 3; ++i) CHECK(traced[i] == Approx(plain[i]).epsilon(0.02));
}

TEST_CASE("multiple scattering makes no energy", "[transport]") {
    // In a closed room that glows everywhere, scattering without loss changes nothing.
    for (const char* const extinction : {"1", "3"}) {
        const Rgb found = seen_in_air(
            std::string("global_settings { max_trace_level 12 integrator { path_traced { bounces "
                        "200 } } } media { scattering { 5, 0.4 eccentricity 0.5 multiple "
                        "extinction ") +
                extinction +
                " } } sphere { 0, 5 inverse hollow pigment { rgb 1 } finish { ambient "
                "0 diffuse 0 emission 2 no_luminaire } }",
            4000, {Vec3(0, 0, -4), Vec3(0, 0, 1)});
        if (*extinction == '1')
            CHECK(found.r == Approx(2).epsilon(0.02));
        else
            CHECK(found.r < 1.5);
    }
}

TEST_CASE("media are not there for low quality, nor beyond what the scene has", "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission 1 } } "
        "}");
    CHECK(shot.world->facts.has_media);
    CHECK_FALSE(shot.world->facts.left_to_chance);
    ParticipatingMedia media(shot);
    DirectLight light(shot, 1);
    LightLedger ledger;
    PathState path;
    path.ray = along_z;
    CHECK(media.along(path, 3, light, ledger).added == Rgb(0));
    path.media.push_back(0);
    CHECK(media.along(path, 3, light, ledger).added == Rgb(3));
    CHECK(media.along(path, std::numeric_limits<double>::infinity(), light, ledger).added ==
          Rgb(0));
}

TEST_CASE("media with multiple scattering change nothing in a furnace", "[transport]") {
    // All that a medium takes it gives: by scattering at an extinction of 1, and by an emission
    // equal to its absorption.
    const char* const media[] = {
        "scattering { 1, 2.4 multiple }",
        "scattering { 2, 1.5 multiple }",
        "scattering { 3, 1.5 multiple }",
        "scattering { 4, 1.5 multiple }",
        "scattering { 5, 2 eccentricity 0.6 multiple }",
        "scattering { 5, 2 eccentricity -0.5 multiple } absorption 0.3 emission 0.3",
        "scattering { 1, rgb <0.5, 2, 1> multiple } absorption 0.6 emission 0.6",
        "scattering { 1, 3 multiple } absorption 0.8 emission 0.8 density { bozo scale 0.3 }",
        "scattering { 3, 2 multiple } } media { scattering { 5, 1 eccentricity 0.7 multiple }"};
    for (const char* const words : media)
        for (const char* const walls : {"", "no_luminaire"}) {
            const Mean seen = mean_seen(
                std::string(
                    "#version 3.7; #default { finish { ambient 0 diffuse 0 } } "
                    "global_settings { max_trace_level 20 integrator { path_traced { bounces "
                    "200 } } } sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { ") +
                    words + " } } } sphere { 0, 9 hollow pigment { rgb 1 } finish { emission 1 " +
                    walls + " } }",
                {Vec3(0.1, 0.2, -5), Vec3(0, 0, 1)}, 2000);
            CAPTURE(words, walls, seen.value, seen.error);
            CHECK(agree(seen, {1, 0}));
        }
}

TEST_CASE("media scatter light that is found by chance as light that is sampled", "[transport]") {
    const std::string solid = "sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { ",
                      closed = " } } } ", open = "media { ";
    const std::pair<std::string, std::string> places[] = {
        {solid + "scattering { 1, 0.1 }" + closed, "in a solid"},
        {solid + "scattering { 1, 0.8 multiple }" + closed, "multiple"},
        {solid + "scattering { 3, 0.4 } absorption 0.2" + closed, "forward"},
        {solid + "scattering { 5, 0.5 eccentricity 0.4 } density { bozo scale 0.4 }" + closed,
         "patchy"},
        {solid + "scattering { 1, 0.3 } } media { scattering { 5, 0.5 eccentricity 0.5 multiple }" +
             closed,
         "mixed"},
        {open + "scattering { 1, 0.03 } } ", "outside"},
        {open + "scattering { 4, 0.05 multiple } } fog { rgb 0 distance 30 } ", "outside and fog"}};
    const std::pair<std::string, std::string> lights[] = {
        {"sky_sphere { pigment { rgb 1 } luminaire } ", "sky_sphere { pigment { rgb 1 } } "},
        {"sphere { 0, 20 hollow pigment { rgb 1 } finish { emission 1 } } ",
         "sphere { 0, 20 hollow pigment { rgb 1 } finish { emission 1 no_luminaire } } "},
        {"box { <-3, 2, -3>, <3, 2.1, 3> pigment { rgb 1 } finish { emission 3 } } ",
         "box { <-3, 2, -3>, <3, 2.1, 3> pigment { rgb 1 } finish { emission 3 no_luminaire } } "},
        {"sphere { <1, 0.5, -0.5>, 1.5 hollow pigment { rgbt 1 } interior { media { emission 1 "
         "absorption 0.3 } luminaire } } ",
         "sphere { <1, 0.5, -0.5>, 1.5 hollow pigment { rgbt 1 } interior { media { emission 1 "
         "absorption 0.3 } } } "}};
    for (const auto& [place, name] : places)
        for (const auto& [sampled, met] : lights) {
            const auto seen = [&](const std::string& light) {
                return mean_seen(
                    "#version 3.7; #default { finish { ambient 0 diffuse 0 } } "
                    "global_settings { integrator { path_traced { bounces 6 } } } "
                    "disc { 4*z, z, 2 pigment { rgb 0 } } " +
                        place + light,
                    {Vec3(0.1, 0.2, -5), Vec3(0, 0, 1)}, 3000);
            };
            const Mean one = seen(sampled), other = seen(met);
            CAPTURE(name, met, one.value, one.error, other.value, other.error);
            CHECK(agree(one, other));
        }
}

TEST_CASE("the first order of scattering has POV-Ray's unit, or that of `multiple`",
          "[transport]") {
    // A thin medium before black, in a furnace: all light comes from it, and nearly none is
    // scattered twice.
    const auto seen = [](const std::string& integrator, const std::string& multiple,
                         const std::string& sky) {
        return mean_seen(
            "#version 3.7; #default { finish { ambient 0 diffuse 0 } } global_settings { "
            "integrator { " +
                integrator +
                " } } disc { 4*z, z, 0.1 pigment { rgb 0 } } "
                "sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, "
                "0.001 " +
                multiple + " } } } } sky_sphere { pigment { rgb 1 } " + sky + " }",
            {Vec3(0, 0, -5), Vec3(0, 0, 1)}, 20000);
    };
    const std::string traced = "path_traced { bounces 3 }";
    const Mean of_povray{4 * 0.002, 0}, physical{0.002, 0};
    for (const char* const sky : {"luminaire", ""}) {
        CHECK(agree(of_povray, seen(traced, "", sky), 0.01));
        CHECK(agree(physical, seen(traced, "multiple", sky), 0.01));
    }
    CHECK(agree(of_povray, seen("pov_ray", "", "luminaire"), 0.01));
    CHECK(agree(of_povray, seen("pov_ray", "multiple", "luminaire"), 0.01));
}

TEST_CASE("media that are luminaires light a place exactly as the place sees them", "[transport]") {
    const std::string ball = "sphere { 0, 0.8 pigment { rgbt 1 } finish { diffuse 0 } hollow ";
    const std::pair<const char*, std::string> solids[] = {
        {"whole", ball},
        {"open above", ball + "clipped_by { plane { y, 0 } } "},
        {"open below", ball + "clipped_by { plane { -y, 0 } } "},
        {"open at a side", ball + "clipped_by { plane { x, 0 } } "},
        {"intersection",
         "intersection { sphere { 0, 0.8 } plane { y, 0 } pigment { rgbt 1 } finish "
         "{ diffuse 0 } hollow "},
        {"tube",
         "cylinder { -0.6*y, 0.6*y, 0.5 open pigment { rgbt 1 } finish { diffuse 0 } hollow "},
        {"cut into a union",
         "union { sphere { -0.3*x, 0.6 } sphere { 0.3*x, 0.6 } clipped_by { "
         "plane { y, 0.2 } } pigment { rgbt 1 } finish { diffuse 0 } hollow "}};
    const std::pair<const char*, std::string> beside[] = {
        {"nothing", ""},
        {"a ceiling", "disc { 4*y, y, 9 pigment { rgb 0 } } "},
        {"a cut pane",
         "box { <-9, 0.5, -9>, <9, 0.7, 9> clipped_by { plane { x, 0.1 } } pigment { "
         "rgbt 1 } finish { diffuse 0 } } "}};
    for (const auto& [name, solid] : solids)
        for (const auto& [what, more] : beside) {
            const auto scene = [&](const std::string& integrator, const std::string& luminaire,
                                   const std::string& floor) {
                return shot_of(
                    "#version 3.7; #default { finish { ambient 0 } } global_settings { "
                    "integrator { " +
                    integrator + " } } " + floor + more + solid +
                    "interior { media { emission 1 absorption 0.3 } " + luminaire +
                    " } translate 2*y }");
            };
            const std::string disc = "disc { 0, y, 0.001 pigment { rgb 1 } finish { diffuse 1 } } ";
            const Ray down{Vec3(0, 0.0005, 0), Vec3(0, -1, 0)};
            const Mean sampled = mean_seen(scene("pov_ray", "luminaire", disc), down, 4000);
            // A fisheye camera at the place, weighted by the cosine.
            const Shot dark = scene("pov_ray", "luminaire", "");
            Integrator integrator(dark, {});
            Draw draw(4);
            Key key;
            double sum = 0, squares = 0;
            constexpr std::uint32_t count = 4000;
            for (; key.sample < count; ++key.sample) {
                const Vec3 towards =
                    cosine_direction(Vec3(0, 1, 0), {draw.number(), draw.number()});
                const double seen = grey(integrator.radiance({Vec3(0), towards}, key));
                sum += seen, squares += seen * seen;
            }
            const double mean = sum / count;
            const Mean sees{mean, std::sqrt(std::fmax(squares / count - mean * mean, 0) / count)};
            const Mean met = mean_seen(scene("path_traced { bounces 1 }", "", disc), down, 4000);
            const Mean traced =
                mean_seen(scene("path_traced { bounces 1 }", "luminaire", disc), down, 4000);
            CAPTURE(name, what, sampled.value, sees.value, met.value, traced.value);
            CHECK(agree(sampled, sees));
            CHECK(agree(traced, sees));
            // Media that are no luminaires also show behind an opening, up to the next surface.
            if (more.empty()) CHECK(agree(met, sees));
        }
}

TEST_CASE("media get the light of sources, luminaires and the sky by one draw", "[transport]") {
    const std::string lamps = R"(
        #declare R = seed(4);
        #macro Place() <6*rand(R) - 3, 3*rand(R) - 1.5, 6*rand(R)> #end
        #for (I, 1, 40)
            light_source { Place(), rgb 0.5*rand(R) fade_distance 0.5 fade_power 2
                #if (mod(I, 3) = 0) spotlight point_at Place() radius 20 falloff 50 #end }
        #end
        #for (I, 1, 20)
            sphere { Place() + 2*y, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0
                emission 40*rand(R) } }
        #end
        box { <-1, -1, 1>, <1, -0.5, 3> pigment { rgb 0.5 } finish { ambient 0 diffuse 0.5 } } )";
    const std::string sky = "sky_sphere { pigment { rgb 0.05 } luminaire } ",
                      thin = "media { scattering { 1, 0.05 } } ",
                      cloud = "media { scattering { 5, 0.1 eccentricity 0.3 } density { bozo } } ";
    for (const std::string& more : {thin, cloud, thin + sky})
        for (const std::string integrator :
             {"", "integrator { path_traced { bounces 1 reflected_luminaires 0 } }"}) {
            const auto seen = [&](const std::string& sampler, std::uint32_t count) {
                return mean_seen("#version 3.7; " + lamps + more + "global_settings { " +
                                     integrator + " light_sampler { " + sampler + " } } ",
                                 {Vec3(0, 0, -5), Vec3(0, 0, 1)}, count);
            };
            const Mean joined = seen("light_octree", 3000), every = seen("every_light", 300);
            CAPTURE(more, integrator, joined.value, every.value, joined.error, every.error);
            CHECK(agree(joined, every, 0.002));
            CHECK(joined.error < 0.02 * joined.value);
        }
}

TEST_CASE("media get the light of a sky alone", "[transport]") {
    const std::string sky =
        "sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } "
        "luminaire } box { <-9, 2, -9>, <9, 3, 2> } "
        "media { scattering { 1, 0.1 } } ";
    const auto seen = [&](const std::string& sampler) {
        return mean_seen(
            "#version 3.7; " + sky + "global_settings { light_sampler { " + sampler + " } } ",
            {Vec3(0, 0, -5), Vec3(0, 0, 1)}, 4000);
    };
    CHECK(agree(seen("light_octree"), seen("every_light"), 0.002));
}

}  // namespace candelabra
