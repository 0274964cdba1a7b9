// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/path_traced.h"

#include "support/draw.h"
#include "support/means.h"
#include "support/scripts.h"
#include "transport/integrator.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the mean of many samples of one ray.
Rgb path_seen(const std::string& script, std::uint32_t count, const Ray& ray) {
    const Shot shot = shot_of(script);
    Integrator integrator(shot, {});
    Rgb sum(0);
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) sum += integrator.radiance(ray, key);
    return sum / static_cast<double>(count);
}

std::string traced(int bounces) {
    return "#version 3.7; global_settings { max_trace_level 12 integrator { path_traced { "
           "bounces " +
           std::to_string(bounces) +
           " reflected_luminaires 0 } } } #default { finish { ambient 0 diffuse 1 } }\n";
}

}  // namespace

TEST_CASE("a closed room that glows everywhere has the sum of all reflections", "[transport]") {
    // L = e (1 + d + d^2 + ...), with one term per bounce, for any shape of room.
    for (const char* const room : {"sphere { 0, 5 inverse", "box { -4, 5 inverse"})
        for (const int bounces : {0, 1, 2, 5}) {
            double expected = 0, power = 1;
            for (int i = 0; i <= bounces; ++i, power *= 0.5) expected += power;
            const Rgb found =
                path_seen(traced(bounces) + room +
                              " pigment { rgb 0.5 } finish { emission 2 no_luminaire } }",
                          4000, {Vec3(0.3, 0.2, 0.1), unit(Vec3(1, 2, 3))});
            CAPTURE(room, bounces);
            CHECK(found.r == Approx(expected).epsilon(0.01));
        }
}

TEST_CASE("in a closed isothermal room all things look the same", "[transport]") {
    // A surface that reflects a share R emits 1 - R of the radiance of a black body (Kirchhoff), so
    // that each thing and each wall shows the black body's radiance, 1, from everywhere.
    const Shot shot = shot_of(R"(#version 3.7; global_settings { max_trace_level 40
        integrator { path_traced { bounces 40 reflected_luminaires 0 } } }
        #macro Grey(R) pigment { rgb R } finish { ambient 0 diffuse 1 emission (1 - R) / R } #end
        box { <-2, -1, -3>, <2, 3, 2> Grey(0.3) }
        sphere { <-0.6, -0.5, 0.5>, 0.5 Grey(0.5) }
        cylinder { <0.8, -1, 0.3>, <0.8, 0.4, 0.3>, 0.4 Grey(0.3) }
        cone { <0, -0.9, 1.3>, 0.6, <0, 0.6, 1.3>, 0.1 Grey(0.5) }
        box { -0.35, 0.35 rotate <20, 30, 10> translate <-1.4, 0.2, 1.2> Grey(0.4) }
        torus { 0.4, 0.12 rotate 60*x translate <1.3, 1.3, 1> Grey(0.5) }
        difference { sphere { 0, 0.4 } box { 0, 1 } translate <0.2, 1.6, 0.4> Grey(0.4) }
        disc { <1.2, -0.98, -0.6>, y, 0.5 Grey(0.2) }
        triangle { <-1.9, -0.9, 1.9>, <-1, -0.9, 1.9>, <-1.9, 0.5, 1.9> Grey(0.3) }
        sphere { <0.2, -0.6, -0.5>, 0.3 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection 1 } })");
    Integrator integrator(shot, {});
    Draw draw(1);
    Key key;
    double sum = 0, squares = 0;
    constexpr int count = 120000;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        Vec3 towards = draw.direction();
        towards.z = std::abs(towards.z);
        const double seen = integrator.radiance({Vec3(-1.5, 0.5, -2.7), towards}, key).r;
        sum += seen, squares += seen * seen;
    }
    const double mean = sum / count;
    INFO("standard error " << std::sqrt((squares / count - mean * mean) / count));
    CHECK(mean == Approx(1).epsilon(1e-3));
}

TEST_CASE("a sheet that is lit from behind shows light from everywhere", "[transport]") {
    // Under a dome of radiance 1 it shows the sum of both its diffuse values.
    for (const char* const integrator : {"pov_ray", "path_traced { reflected_luminaires 0 }"})
        for (const auto& [finish, expected] : std::vector<std::pair<std::string, double>>{
                 {"diffuse 0.4, 0.4", 0.8}, {"diffuse 0.7, 0.3", 1.0}, {"diffuse 0, 0.6", 0.6}}) {
            const Rgb seen = path_seen(
                "#version 3.7; global_settings { integrator { " + std::string(integrator) +
                    " } } sphere { 0, 20 hollow pigment { rgb 1 } finish { ambient 0 diffuse 0 "
                    "emission 1 } } polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> "
                    "pigment { rgb 1 } finish { ambient 0 " +
                    finish + " } }",
                4000, {Vec3(0.1, 0.2, -3), Vec3(0, 0, 1)});
            CAPTURE(integrator, finish);
            CHECK(seen.r == Approx(expected).epsilon(0.01));
        }
}

namespace {

/// A closed body with normals that make it look round, in various forms.
std::vector<std::string> smooth_bodies() {
    const std::string mesh =
        "mesh2 { vertex_vectors { 4, <-0.9, -0.7, -0.9>, <0.9, -0.7, -0.9>, <0, -0.7, 0.9>, "
        "<0, 0.9, 0> } normal_vectors { 4, <-1, -0.5, -1>, <1, -0.5, -1>, <0, -0.5, 1>, y } "
        "face_indices { 4, <0, 1, 3>, <1, 2, 3>, <2, 0, 3>, <0, 2, 1> } inside_vector y ";
    return {mesh, mesh + "clipped_by { sphere { 0, 3 } } ", mesh + "rotate 30 scale <1, -1.5, 1> ",
            "intersection { " + mesh + "} sphere { 0, 3 } "};
}

}  // namespace

TEST_CASE("a convex body that glows does not light itself, however smooth it looks",
          "[transport]") {
    for (const std::string& body : smooth_bodies())
        for (const char* const integrator :
             {"pov_ray", "path_traced { reflected_luminaires 200 }"}) {
            const Shot shot = shot_of(
                "#version 3.7; global_settings { integrator { " + std::string(integrator) +
                " } } " + body + "pigment { rgb 1 } finish { ambient 0 diffuse 0.5 emission 1 } }");
            Integrator integrating(shot, {});
            Draw draw(7);
            Key key;
            int met = 0;
            CAPTURE(body, integrator);
            for (key.sample = 0; key.sample < 300; ++key.sample) {
                const Vec3 from = 5.0 * draw.direction();
                const double seen =
                    integrating.radiance({from, unit(draw.point(0.7) - from)}, key).r;
                if (seen == 0) continue;
                CHECK(seen == Approx(1).epsilon(1e-9));
                ++met;
            }
            CHECK(met > 100);
        }
}

TEST_CASE("a closed body keeps the light of a lamp inside, however smooth it looks",
          "[transport]") {
    for (const std::string& body : smooth_bodies())
        for (const std::string lamp :
             {"sphere { 0, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 50 } } ",
              "light_source { 0, rgb 1 } "}) {
            const Shot shot =
                shot_of(traced(4) + lamp + body +
                        "pigment { rgb 1 } } box { <-9, -4, -9>, <9, -3, 9> pigment { rgb 1 } }");
            Integrator integrating(shot, {});
            Draw draw(8);
            Key key;
            double sum = 0;
            CAPTURE(body, lamp);
            for (key.sample = 0; key.sample < 3000; ++key.sample) {
                const Vec3 from = 5.0 * draw.direction();
                sum += integrating.radiance({from, unit(draw.point(1) - from)}, key).r;
            }
            CHECK(sum == 0);
        }
}

TEST_CASE("white facets disappear before a white sky, at every angle and with any bumps",
          "[transport]") {
    for (const std::string facets : {"metallic 0 roughness 0.05", "metallic 1 roughness 0.05",
                                     "metallic 1 roughness 0.6", "metallic 0 roughness 0.3 coat 1"})
        for (const std::string bumps :
             {"", "normal { bumps 0.3 scale 0.01 }", "normal { bumps 2 scale 0.01 }"})
            for (const double elevation : {0.05, 0.3}) {
                const Shot shot =
                    shot_of(traced(1) +
                            "sky_sphere { pigment { rgb 1 } } plane { y, 0 pigment { rgb 1 } "
                            "finish { microfacet { " +
                            facets + " } } " + bumps + " }");
                Integrator integrating(shot, {});
                Draw draw(9);
                Key key;
                double sum = 0, squares = 0;
                constexpr int count = 6000;
                for (key.sample = 0; key.sample < count; ++key.sample) {
                    const double x = draw.between(-1, 1);
                    const double seen =
                        integrating.radiance({Vec3(x, 1, 0), unit(Vec3(0.1, -elevation, 1))}, key)
                            .r;
                    sum += seen, squares += seen * seen;
                }
                const double mean = sum / count;
                const double error = std::sqrt((squares / count - mean * mean) / count);
                CAPTURE(facets, bumps, elevation, error);
                CHECK(mean == Approx(1).margin(0.015 + 4 * error));
            }
}

TEST_CASE("luminaires light by reflections as surfaces that glow do", "[transport]") {
    // Light of luminaires is sampled by the strategy, which looks one reflection further; light of
    // other glowing surfaces is found by chance.
    const auto corner = [](int bounces, const std::string& finish) {
        return path_seen(traced(bounces) + R"(
            plane { y, 0 pigment { rgb 0.8 } } plane { x, 0 pigment { rgb <0.9, 0.3, 0.2> } }
            sphere { <3, 2.5, 0>, 1.5 pigment { rgb 1 } finish { diffuse 0.5 emission 4 )" +
                             finish + " } }",
                         60000, {Vec3(3, 3, -9), unit(Vec3(-2, -3, 9))});
    };
    const Rgb chosen = corner(2, ""), met = corner(3, "no_luminaire");
    for (int i = 0; i < 3; ++i) CHECK(chosen[i] == Approx(met[i]).epsilon(0.03));
}

TEST_CASE("without bounces all integrators see the same", "[transport]") {
    const std::string scene = R"(
        plane { y, -1 pigment { checker rgb 0.9, rgb <0.6, 0.3, 0.2> } finish { reflection 0.3 } }
        sphere { <-1.5, 0, 0>, 1 pigment { rgbf <0.9, 1, 0.9, 0.8> }
            finish { specular 0.5 reflection { 0.1, 0.4 fresnel } } interior { ior 1.4 } }
        sphere { <1.5, 0, 0>, 1 texture { pigment { rgb 0.7 } } texture { pigment { rgbt <1, 0, 0, 0.5> } finish { phong 1 } } }
        sphere { <0, 2, 0.5>, 0.3 pigment { rgb 1 } finish { diffuse 0 emission <2, 3, 1> } }
        light_source { <-4, 6, -4>, rgb <1, 0.8, 0.5> }
        fog { distance 40 rgb 0.1 } background { rgb <0.1, 0.2, 0.3> })";
    const std::string pov =
        "#version 3.7; global_settings { max_trace_level 12 adc_bailout 0 } "
        "#default { finish { ambient 0 diffuse 1 } }\n";
    for (const Vec3& towards : {Vec3(-1.5, 0.1, 0), Vec3(1.4, 0.2, 0), Vec3(0.2, -1, -1)}) {
        const Ray ray{Vec3(0, 1, -6), unit(towards - Vec3(0, 1, -6))};
        const Rgb one = path_seen(pov + scene, 4000, ray),
                  other = path_seen(traced(0) + scene, 40000, ray);
        CAPTURE(towards.x);
        for (int i = 0; i < 3; ++i) CHECK(other[i] == Approx(one[i]).epsilon(0.03));
    }
}

TEST_CASE("light that photons bring by a mirror lights others as light that is met by chance",
          "[transport]") {
    // The lamp stands in a cup and shines up only, at a mirror, which lights the floor, which
    // lights the wall.
    const auto seen = [](const std::string& mirror, int bounces, const Vec3& towards,
                         std::uint32_t count) {
        const Shot shot = shot_of(R"(#version 3.7;
            global_settings { photons { count 200000 radius 0.2 }
                integrator { path_traced { reflected_luminaires 0 bounces )" +
                                  std::to_string(bounces) + R"( } } }
            #default { finish { ambient 0 diffuse 1 } }
            plane { y, 0 pigment { rgb <0.8, 0.6, 0.4> } }
            box { <-4, 0, 2>, <4, 3, 2.1> pigment { rgb 0.7 } }
            disc { <0, 5, 0>, y, 1.2 pigment { rgb 0 } finish { reflection 0.9 } )" +
                                  mirror +
                                  R"( }
            sphere { <0, 3, 0>, 0.5 pigment { rgb 1 } finish { diffuse 0 emission 20 } }
            cylinder { <0, 2.4, 0>, <0, 3.8, 0>, 0.6 open pigment { rgb 0 } }
            disc { <0, 2.4, 0>, y, 0.6 pigment { rgb 0 } })");
        Integrator integrator(shot, {});
        const Vec3 camera(0.5, 1.5, -5);
        Draw draw(2);
        Rgb sum(0);
        Key key;
        constexpr std::uint32_t rays = 100;
        for (; key.sample < count; ++key.sample)
            for (key.pixel = 0; key.pixel < rays; ++key.pixel) {
                const Vec3 place =
                    towards + Vec3(draw.between(-0.5, 0.5), draw.between(-0.5, 0.5), 0);
                sum += integrator.radiance({camera, unit(place - camera)}, key);
            }
        return sum / static_cast<double>(count * rays);
    };
    const std::string target = "photons { target reflection on refraction off }";
    for (const Vec3& towards : {Vec3(1, 0.5, -1), Vec3(0.5, 0.8, 2)}) {
        const Rgb brought = seen(target, 1, towards, 300), met = seen("", 2, towards, 30000);
        CAPTURE(towards.z);
        for (int i = 0; i < 3; ++i) CHECK(brought[i] == Approx(met[i]).epsilon(0.03));
    }
}

TEST_CASE("a thin surface lets diffuse light through to what is behind", "[transport]") {
    // A sheet that only transmits light diffusely, between the camera and a glowing wall.
    const auto seen = [](const std::string& finish) {
        return path_seen(traced(1) +
                             "plane { z, 5 pigment { rgb 1 } finish { diffuse 0 emission 1 "
                             "no_luminaire } } disc { 0, z, 100 pigment { rgb 1 } finish { " +
                             finish + " } }",
                         2000, {Vec3(0, 0, -3), Vec3(0, 0, 1)})
            .r;
    };
    CHECK(seen("diffuse 0, 0.5") == Approx(0.5).epsilon(0.02));
    CHECK(seen("diffuse 0.5, 0") == 0);
}

TEST_CASE("no solid makes light in a furnace", "[transport]") {
    // Before a radiance of 1 everywhere no weight of a path comes to more than 1, unless white light
    // is split: then the mean does not.
    const std::string half = " pigment { rgbt <1, 1, 1, 0.6> } ";
    const std::string glossy = "reflection { 0, 1 fresnel } conserve_energy ";
    const std::pair<std::string, double> solids[] = {
        {"sphere { 0, 1" + half + "finish { diffuse 1 } interior { ior 1.05 } }", 1},
        {"sphere { 0, 1" + half + "finish { diffuse 1 } interior { ior 1.5 } }", 1},
        {"sphere { 0, 1" + half + "finish { diffuse 1 } interior { ior 2.4 } }", 1},
        {"sphere { 0, 1" + half + "finish { diffuse 1 } interior { ior 0.7 } }", 1},
        {"box { -0.8, 0.8 rotate <30, 40, 0>" + half +
             "finish { diffuse 1 } interior { ior 1.3 } }",
         1},
        {"sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.9> } finish { diffuse 1 } interior { ior 1.5 } "
         "}",
         1},
        {"sphere { 0, 1" + half + "finish { diffuse 0.5, 0.5 } interior { ior 1.5 } }", 1},
        {"sphere { 0, 1 pigment { rgbf <0.9, 1, 0.8, 0.7> } finish { diffuse 0.8 } interior { ior "
         "1.31 } }",
         1},
        {"merge { sphere { -0.3*x, 0.7 } box { -0.6, 0.6 }" + half +
             "finish { diffuse 1 } interior { "
             "ior 1.5 } }",
         1},
        {"sphere { 0, 1 clipped_by { plane { y, 0.3 } }" + half +
             "finish { diffuse 1 } interior { ior "
             "1.5 } }",
         1},
        {"sphere { 0, 1 texture {" + half + "finish { diffuse 1 } } texture {" + half +
             "finish { diffuse 1 } } interior { ior 1.5 } }",
         1},
        {"sphere { 0, 1" + half + "finish { diffuse 1 " + glossy + "} interior { ior 1.5 } }", 1},
        {"sphere { 0, 1 pigment { rgb 1 } finish { diffuse 1 " + glossy +
             "} interior { ior 1.5 } }",
         1},
        {"sphere { 0, 1 pigment { rgb 1 } finish { diffuse 0.9 reflection 0.4 conserve_energy } }",
         1},
        {"sphere { 0, 1" + half + "finish { diffuse 1 } interior { ior 1.5 dispersion 1.1 } }", 3}};
    for (const auto& [solid, greatest] : solids) {
        const Shot shot = shot_of(
            traced(30) + "camera { location <0.3, 0.9, -3.3> } background { rgb 1 } " + solid);
        Integrator integrator(shot, {});
        Draw draw(3);
        Key key;
        double sum = 0, most = 0;
        constexpr std::uint32_t count = 4000;
        for (; key.sample < count; ++key.sample) {
            const Vec3 towards(draw.between(-0.9, 0.9), draw.between(-0.9, 0.9), 0);
            const Vec3 from(0.3, 0.9, -3.3);
            const Rgb seen = integrator.radiance({from, unit(towards - from)}, key);
            sum += grey(seen), most = std::fmax(most, max_component(seen));
        }
        CAPTURE(solid);
        CHECK(sum / count < (greatest == 1 ? 1.01 : 1.06));
        CHECK(sum / count > 0.5);
        if (greatest == 1) CHECK(most <= 1 + 1e-9);
    }
}

TEST_CASE("facets over half-clear solids keep all light of a furnace and make none",
          "[transport]") {
    const std::string rough = "roughness 0.3";
    const auto ball = [](const std::string& clear, const std::string& facets,
                         const std::string& interior) {
        return "sphere { 0, 1 pigment { rgbt <1, 1, 1, " + clear + "> } finish { microfacet { " +
               facets + " } } interior { " + interior + " } }";
    };
    const std::string look =
        " pigment { rgbt <1, 1, 1, 0.6> } finish { microfacet { roughness 0.3 } } ";
    const std::string inside = "interior { ior 1.5 } }";
    const std::string solids[] = {
        ball("0.3", rough, "ior 1.5"),
        ball("0.6", "roughness 0.05", "ior 1.5"),
        ball("0.6", "roughness 0.6", "ior 1.05"),
        ball("0.9", rough, "ior 2"),
        ball("0.6", rough, "ior 0.7"),
        ball("0.6", "roughness 0.3 coat 1", "ior 1.5"),
        ball("0.6", "roughness 0.3 metallic 0.5", "ior 1.5"),
        ball("0.5", "roughness 0.4 metallic 1", "ior 1"),
        "sphere { 0, 1 texture {" + look + "} texture {" + look + "} " + inside,
        "sphere { 0, 1 texture {" + look + "} texture { pigment { rgb 1 } finish { diffuse 1 } } " +
            inside,
        "sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.6> } finish { microfacet { roughness 0.3 } "
        "reflection { 0, 1 fresnel } conserve_energy } " +
            inside,
        "sphere { 0, 1 pigment { rgb 1 } finish { microfacet { roughness 0.3 } reflection 0.3 "
        "conserve_energy } }",
        "box { -0.7, 0.7 rotate <30, 40, 0>" + look + inside,
        "difference { sphere { 0, 1 } sphere { <0.5, 0.5, -0.5>, 0.6 }" + look + inside,
        "sphere { 0, 1 clipped_by { plane { y, 0.3 } }" + look + inside};
    const std::string sky = "background { rgb 1 } ";
    for (const std::string& solid : solids) {
        const Shot shot = shot_of(
            "#version 3.7; global_settings { max_trace_level 40 integrator { path_traced { "
            "bounces 30 reflected_luminaires 0 } } } #default { finish { ambient 0 diffuse 1 } "
            "} camera { location <0.3, 0.9, -3.3> } " +
            sky + solid);
        Integrator integrator(shot, {});
        Draw draw(4);
        Key key;
        double sum = 0, squares = 0;
        constexpr std::uint32_t count = 2000;
        for (; key.sample < count; ++key.sample) {
            const Vec3 from(0.3, 0.9, -3.3),
                towards(draw.between(-0.8, 0.8), draw.between(-0.8, 0.8), 0);
            const double seen = grey(integrator.radiance({from, unit(towards - from)}, key));
            sum += seen, squares += seen * seen;
        }
        const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
        CAPTURE(solid, sky, mean, error);
        CHECK(mean < 1.01 + 4.5 * error);
        CHECK(mean > 0.97 - 4.5 * error);
    }
}

TEST_CASE("glass dims light that is sampled as light that is found by chance", "[transport]") {
    const std::string glossy =
        " pigment { rgbt 1 } finish { diffuse 0 reflection { 0, 1 fresnel } conserve_energy } ";
    const std::string pane =
                          "box { <-90, 1, -90>, <90, 1.1, 90>" + glossy + "interior { ior 1.5 } } ",
                      second =
                          "box { <-90, 2, -90>, <90, 2.1, 90>" + glossy + "interior { ior 1.5 } } ",
                      mirrored =
                          "box { <-90, 1, -90>, <90, 1.1, 90> pigment { rgbt 1 } finish { "
                          "diffuse 0 reflection 0.3 conserve_energy } } ",
                      tinted =
                          "box { <-90, 1, -90>, <90, 1.1, 90> texture { pigment { rgbf <0.9, 0.8, "
                          "0.7, 1> } finish { diffuse 0 reflection 0.2 conserve_energy } } } ";
    const std::pair<std::string, std::string> lights[] = {
        {"sky_sphere { pigment { rgb 1 } luminaire } ", "sky_sphere { pigment { rgb 1 } } "},
        {"sphere { 0, 500 pigment { rgb 1 } finish { diffuse 0 emission 1 } } ",
         "sphere { 0, 500 pigment { rgb 1 } finish { diffuse 0 emission 1 no_luminaire } } "}};
    const Ray ray{Vec3(0, 0.5, -0.5), unit(Vec3(0, -1, 1))};
    for (const std::string& glass : {pane, pane + second, mirrored, tinted})
        for (const auto& [sampled, met] : lights) {
            const std::string scene = traced(6) + "plane { y, 0 pigment { rgb 0.5 } } " + glass;
            CAPTURE(glass, met);
            CHECK(
                agree(mean_seen(scene + sampled, ray, 10000), mean_seen(scene + met, ray, 10000)));
        }
}

TEST_CASE("clear glass changes nothing in a furnace", "[transport]") {
    const std::string ball =
        "sphere { 1.2*y, 1 pigment { rgbt 1 } finish { diffuse 0 reflection { 0, 1 fresnel } "
        "conserve_energy } interior { ior 1.5 } } ";
    for (const char* const walls : {"", "no_luminaire"}) {
        const Mean seen = mean_seen(
            traced(40) + ball +
                "plane { y, 0 pigment { rgb 0.5 } finish { diffuse 1 emission 1 no_luminaire } } "
                "sphere { 0, 50 hollow pigment { rgb 1 } finish { diffuse 0 emission 1 " +
                walls + " } } ",
            {Vec3(0.3, 0.1, -0.5), unit(Vec3(0, -1, 1))}, 20000);
        // The floor emits half of what it would reflect in a furnace of 1.
        CAPTURE(walls);
        CHECK(agree(seen, {1, 0}));
    }
}

}  // namespace candelabra
