// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_light.h"

#include "support/ball_lens.h"
#include "support/means.h"
#include "support/scripts.h"
#include "transport/integrator.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Mean radiance over points of a floor, in a ring around the axis, over some samples.
double seen_on_floor(Integrator& integrator, double from, double to, int samples,
                     const Vec3& above = Vec3(0, 0.5, 0), int first = 0) {
    double sum = 0;
    constexpr int places = 64;
    for (int i = 0; i < places; ++i)
        for (int sample = first; sample < first + samples; ++sample) {
            const double share = (i + 0.5) / places, angle = 2.4 * i;
            // Uniform in the ring.
            const double away = std::sqrt(from * from + share * (to * to - from * from));
            Key key;
            key.pixel = static_cast<std::uint64_t>(i);
            key.sample = static_cast<std::uint32_t>(sample);
            sum += integrator
                       .radiance({above + away * Vec3(std::cos(angle), 0, std::sin(angle)),
                                  Vec3(0, -1, 0)},
                                 key)
                       .r;
        }
    return sum / (places * samples);
}

std::string lens_over_floor(const std::string& photons, const std::string& lamp) {
    return "#version 3.7; #default { pigment { rgb 1 } } global_settings { photons { " + photons +
           " } } " + lamp +
           R"( sphere { 5*y, 1 pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1.5 }
                        photons { target refraction on } }
               plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } })";
}

}  // namespace

TEST_CASE("a caustic is as bright as exact geometry says", "[transport][statistics]") {
    const BallLens lens;
    const Shot shot =
        shot_of(lens_over_floor("count 20000", "light_source { 90*y, rgb 1 parallel point_at 0 }"));
    Integrator integrator(shot, {});
    // The ball's shadow ends at 1; beyond it, direct light arrives as well.
    for (const auto& [from, to, straight] :
         {std::tuple(0.2, 0.4, 0.0), std::tuple(0.5, 0.8, 0.0), std::tuple(1.2, 1.5, 1.0),
          std::tuple(1.6, 2.0, 1.0)}) {
        INFO("between " << from << " and " << to);
        CHECK(seen_on_floor(integrator, from, to, 16) - straight ==
              Approx(lens.density(from, to)).epsilon(0.02).margin(0.002));
    }
}

TEST_CASE("a caustic of 300 lamps is that of their sum", "[transport][statistics]") {
    // A bundle of far lamps, whose light is nearly parallel.
    const Shot shot = shot_of(lens_over_floor("count 20000", R"(
        #for (I, 0, 299)
            sphere { <mod(I, 20) - 9.5, 2000, floor(I/20) - 7>, 0.4 hollow pigment { rgb 1 }
                     finish { emission 2000*2000/(0.16*300) } }
        #end)"));
    const BallLens lens;
    Integrator integrator(shot, {});
    CHECK(seen_on_floor(integrator, 0.5, 0.8, 32) == Approx(lens.density(0.5, 0.8)).epsilon(0.03));
}

TEST_CASE("a disc of glass that bends nothing changes nothing", "[transport][statistics]") {
    const auto light = [](const std::string& lamp, const std::string& photons) {
        const Shot shot =
            shot_of("#version 3.7; #default { pigment { rgb 1 } } global_settings { " + photons +
                    " } " + lamp +
                    R"( box { <-2, 1, -2>, <2, 1.2, 2> pigment { rgbt 1 }
                                         finish { diffuse 0 } photons { target refraction on } }
                                         plane { y, 0 pigment { rgb 1 } finish { ambient 0 } })");
        Integrator integrator(shot, {});
        return seen_on_floor(integrator, 0, 1.2, photons.empty() ? 64 : 16);
    };
    for (const char* lamp :
         {"light_source { 6*y, rgb 1 }", "light_source { 6*y, rgb 1 fade_distance 3 fade_power 2 }",
          "light_source { 2*y, rgb 1 }", "sphere { 6*y, 0.5 finish { emission 9 } }",
          "sphere { <0.3, 2, 0>, 0.2 finish { emission 9 } }",
          "sphere { <0.3, 3.2, 0>, 0.4 finish { emission 9 } }",
          "box { <-0.5, 6, -0.5>, <0.5, 6.1, 0.5> finish { emission 9 } }",
          "triangle { <-1, 6, -1>, <1, 6, -1>, <0, 6, 1> finish { emission 9 } }",
          "difference { sphere { 6*y, 1 } box { <-2, 5.4, -2>, <2, 5.5, 2> } finish { emission 9 "
          "} }"}) {
        INFO(lamp);
        CHECK(light(lamp, "photons { count 20000 }") == Approx(light(lamp, "")).epsilon(0.03));
    }
}

TEST_CASE("photons bring light of all kinds of lamps through air as it comes without them",
          "[transport][statistics]") {
    // A disc of glass that bends nothing, below lamps that are seen through their openings, on one
    // side, through themselves, or without a shadow.
    const std::string gas =
        " hollow pigment { rgbt 1 } finish { diffuse 0 } interior { media { emission 4 absorption "
        "0.5 } luminaire } ";
    const std::string dark = "texture { pigment { rgb 1 } finish { diffuse 0 } } ",
                      glow = "texture { pigment { rgb 1 } finish { diffuse 0 emission 9 } } ";
    const std::string lamps[] = {
        "sphere { 4*y, 1" + gas + "}",
        "sphere { 4*y, 1 clipped_by { plane { y, 4 } }" + gas + "}",
        "sphere { 4*y, 1 clipped_by { plane { -y, -4 } }" + gas + "}",
        "sphere { 4*y, 1 clipped_by { cylinder { 0, 9*y, 0.5 inverse } }" + gas + "}",
        "cylinder { <0, 4, -1>, <0, 4, 1>, 0.8 open" + gas + "} plane { -y, -9 pigment { rgb 0 } }",
        "sphere { 1.8*y, 0.5 clipped_by { plane { x, 0 } }" + gas + "}",
        "sphere { 4*y, 1 no_shadow" + gas + "}",
        "disc { 4*y, -y, 1 " + glow + "interior_" + dark + "}",
        "disc { 4*y, y, 1 " + dark + "interior_" + glow + "}",
        "sphere { 4*y, 1 clipped_by { plane { -y, -4 } } " + dark + "interior_" + glow + "}",
        "sphere { 4*y, 1 pigment { rgbt <1, 1, 1, 0.5> } finish { diffuse 0 emission 4 } }",
        "torus { 0.8, 0.2 translate 4*y no_shadow pigment { rgb 1 } finish { diffuse 0 emission 9 "
        "} "
        "}"};
    for (const std::string& lamp : lamps)
        for (const std::string air : {"", "fog { rgb 0 distance 5 } ", "media { absorption 0.2 } "})
            for (const char* const integrator : {"pov_ray", "path_traced { bounces 0 }"}) {
                const auto light = [&](const std::string& photons) {
                    const Shot shot = shot_of(
                        "#version 3.7; #default { pigment { rgb 1 } finish { ambient 0 } } "
                        "global_settings { " +
                        photons + " integrator { " + integrator +
                        " } } camera { location 0.5*y } " + air + lamp +
                        R"( box { <-3, 1, -3>, <3, 1.2, 3> hollow pigment { rgbt 1 }
                            finish { diffuse 0 } photons { target refraction on } }
                            plane { y, 0 pigment { rgb 1 } })");
                    // The first samples have photons of their own.
                    Integrator integrating(shot, {});
                    double sum = 0, squares = 0;
                    constexpr int samples = 12;
                    for (int i = 0; i < samples; ++i) {
                        const double seen =
                            seen_on_floor(integrating, 0, 1.2, 1, Vec3(0, 0.5, 0), i);
                        sum += seen, squares += seen * seen;
                    }
                    const double mean = sum / samples;
                    return Mean{mean, std::sqrt(std::fmax(squares / samples - mean * mean, 0) /
                                                (samples - 1))};
                };
                const Mean brought = light("photons { count 4000 }"), straight = light("");
                CAPTURE(lamp, air, integrator, brought.value, brought.error, straight.value);
                // Discs of photons spread the edges of light.
                const bool dark = std::fmax(straight.value, brought.value) < 1e-3;
                CHECK((dark || agree(straight, brought, 0.05)));
            }
}

TEST_CASE("light that photons bring is counted for its lamp", "[transport]") {
    const Shot shot = shot_of(
        lens_over_floor("count 4000",
                        "light_source { 90*y, rgb 1 parallel point_at 0 } light_source { <0, 90, "
                        "1>, rgb 1 parallel point_at z shadowless }"));
    Tracing wanted;
    wanted.counts_lights = true;
    Integrator integrator(shot, wanted);
    const double seen = grey(integrator.radiance({Vec3(0.5, 1, 0), Vec3(0, -1, 0)}, Key())) - 1;
    CHECK(seen > 0);
    CHECK(integrator.ledger().lights[0].light.value() == Approx(seen));
    CHECK(integrator.ledger().lights[1].light.value() == Approx(1));
}

TEST_CASE("what reflects light of lamps to targets shows them once", "[transport][statistics]") {
    // Radiosity gathers a lamp through a mirror; photons bring that light, too.
    const auto light = [](const std::string& photons) {
        const Shot shot =
            shot_of(R"(#version 3.7; #default { pigment { rgb 1 } } global_settings { radiosity {
            recursion_limit 1 } )" +
                    photons +
                    R"( } sphere { <-2, 2.5, 0>, 1.5 finish { emission 5 } }
            box { <2, 0, -3>, <2.1, 4, 3> pigment { rgb 0 } finish { diffuse 0 reflection 1 }
                  photons { target reflection on } }
            plane { y, 0 pigment { rgb 1 } finish { ambient 0 } })");
        Integrator integrator(shot, {});
        return seen_on_floor(integrator, 0, 0.5, 400, Vec3(0.5, 0.5, 0));
    };
    CHECK(light("photons { count 8000 }") == Approx(light("")).epsilon(0.03));
}

}  // namespace candelabra
