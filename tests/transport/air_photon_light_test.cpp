// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photon_light.h"

#include "support/scripts.h"
#include "transport/integrator.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A clear pane over a box of haze, which is lit from above, and a camera ray through the haze.
std::string haze_under_pane(const std::string& photons, const std::string& media,
                            const std::string& lamp =
                                "light_source { <0, 50, 0>, rgb 0.6 "
                                "parallel point_at 0 $ }") {
    std::string own = lamp;
    const std::size_t words = own.find('$');
    if (words != std::string::npos) own.replace(words, 1, "photons { refraction on }");
    return "#version 3.7; camera { location <0.1, 0.4, -5> } global_settings { photons { " +
           photons + " } } " + own +
           "box { <-1, 1, -1>, <1, 1.2, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } "
           "interior { ior 1.5 } photons { target refraction on } } "
           "box { <-0.5, 0.1, -0.5>, <0.5, 0.7, 0.5> pigment { rgbt 1 } finish { ambient 0 diffuse "
           "0 } hollow interior { " +
           media + " } } plane { y, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }";
}

double seen_in_haze(const std::string& script, std::uint32_t samples = 16) {
    const Shot shot = shot_of(script);
    Integrator integrator(shot, {});
    double sum = 0;
    Key key;
    for (key.sample = 0; key.sample < samples; ++key.sample)
        sum += integrator.radiance({Vec3(0.1, 0.4, -5), Vec3(0, 0, 1)}, key).r / samples;
    return sum;
}

const std::string isotropic = "media { scattering { 1, rgb 0.3 extinction 0 } }";

}  // namespace

TEST_CASE("haze below a pane is as bright as without the pane", "[transport]") {
    CHECK(seen_in_haze(haze_under_pane("count 10000 media 4", isotropic)) ==
          Approx(0.18).epsilon(0.03));
    CHECK(seen_in_haze(haze_under_pane("count 10000 media 4",
                                       "media { scattering { 5, rgb 0.3 "
                                       "eccentricity 0.5 extinction 0 } }")) ==
          Approx(0.3 * 0.6 * 0.75 / std::pow(1.25, 1.5)).epsilon(0.03));
    // The density is linear; its mean along the ray is a half.
    CHECK(seen_in_haze(haze_under_pane("count 10000 media 4",
                                       "media { scattering { 1, rgb 0.3 extinction 0 } density { "
                                       "gradient z translate -0.5*z } }"),
                       64) == Approx(0.09).epsilon(0.05));
}

TEST_CASE("haze behind a target is dark, or lit straight, if the scene says so", "[transport]") {
    CHECK(seen_in_haze(haze_under_pane("count 10000", isotropic)) == 0);
    CHECK(seen_in_haze(
              haze_under_pane("count 10000 media 4",
                              "media { scattering { 1, rgb 0.3 extinction 0 } collect off }")) ==
          Approx(0.18).epsilon(0.01));
}

TEST_CASE("media dim what photons bring on both ways", "[transport]") {
    const double found = seen_in_haze(
        haze_under_pane("count 20000 media 4", "media { scattering { 1, rgb 0.3 extinction 2 } }"));
    const double expected = 0.6 * std::exp(-0.6 * 0.3) * 0.3 * (1 - std::exp(-0.6)) / 0.6;
    CHECK(found == Approx(expected).epsilon(0.03));
}

TEST_CASE("the light that photons bring to the air is their lamps'", "[transport]") {
    const Shot shot = shot_of(haze_under_pane("count 5000 media 2", isotropic));
    Tracing tracing;
    tracing.counts_lights = true;
    Integrator integrator(shot, tracing);
    const Rgb found = integrator.radiance({Vec3(0.1, 0.4, -5), Vec3(0, 0, 1)}, {});
    Rgb of_lamp(0);
    take_lights(integrator.ledger(), [&](std::size_t, const Rgb& light) { of_lamp += light; });
    CHECK(found.r > 0);
    CHECK(of_lamp.r == Approx(found.r));
}

TEST_CASE("luminaires shoot photons into the air, too", "[transport]") {
    // A pane that does not refract leaves the brightness as it is.
    const std::string lamp =
        "sphere { <0, 4, 0>, 0.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 20 } }";
    std::string scene = haze_under_pane("count 20000 media 4", isotropic, lamp);
    scene.replace(scene.find("ior 1.5"), 7, "ior 1.0");
    std::string plain = scene;
    plain.replace(plain.find("target refraction on"), 20, "");
    CHECK(seen_in_haze(scene, 32) == Approx(seen_in_haze(plain, 4000)).epsilon(0.04));
}

}  // namespace candelabra
