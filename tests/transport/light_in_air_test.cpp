// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_in_air.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace candelabra {

namespace {

bool lit(const std::string& scene) {
    return stands_for_scattering(
        *world_of("#version 3.7; global_settings { integrator { path_traced } } " + scene));
}

}  // namespace

TEST_CASE("reflected luminaires stand for what media scatter, except beside rules of POV-Ray",
          "[transport]") {
    const std::string fog = "media { scattering { 1, 0.1 } } ",
                      forward = "media { scattering { 5, 0.1 eccentricity 0.5 } } ",
                      area = "light_source { y, 1 area_light x, z, 2, 2 } ";
    const auto cloud = [](const std::string& shape, const std::string& more) {
        return shape + " hollow pigment { rgbt 1 } " + more +
               " interior { media { scattering { 1, 0.1 } } } }";
    };
    CHECK(lit(fog));
    CHECK(lit(forward + "light_source { y, 1 }"));
    CHECK(lit(fog + area));
    CHECK(lit(cloud("sphere { 0, 1", "")));
    CHECK_FALSE(lit("sphere { 0, 1 }"));
    CHECK_FALSE(lit("media { absorption 0.1 }"));
    CHECK_FALSE(lit(forward + area));
    CHECK_FALSE(lit(fog + "fog { distance 9 rgb 0.1 }"));
    CHECK_FALSE(lit(cloud("sphere { 0, 1", "no_shadow")));
    CHECK_FALSE(lit(cloud("cylinder { 0, y, 1 open", "")));
}

TEST_CASE("places on a line of light stand for all of it", "[transport]") {
    Media even, thin;
    even.scattering.colour = Rgb(0.3);
    thin.absorption = Rgb(0);
    thin.scattering.colour = Rgb(1e-9);
    const LitRegion region{Vec3(4, 1, 0), 1.5, 1e5};
    const Ray ray{Vec3(0), Vec3(1, 0, 0)};
    for (const Media* media : {&even, &thin})
        for (const double length : {0.5, 6.0, 200.0, double(INFINITY)}) {
            const Media* const list[] = {media};
            double sum = 0, squares = 0;
            constexpr std::uint32_t count = 40000;
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto place = place_on_line(list, ray, length, region, {}, {3, i, 0, 0});
                REQUIRE(place);
                REQUIRE(place->distance >= 0);
                REQUIRE(place->distance <= length);
                // Light that comes from about the region.
                const double x = place->distance - 4;
                const double light = place->stands_for / ((1 + x * x) * std::sqrt(1 + x * x));
                sum += light;
                squares += light * light;
            }
            const double mean = sum / count,
                         sigma = std::sqrt((squares / count - mean * mean) / count);
            const auto integral = [](double x) { return x / std::sqrt(1 + x * x); };
            const double end = std::fmin(length, 1e6);
            CAPTURE(length, mean);
            CHECK(std::abs(mean - (integral(end - 4) - integral(-4))) < 4 * sigma + 1e-9);
        }
    CHECK_FALSE(place_on_line({}, ray, 0, region, {}, {}));
}

}  // namespace candelabra
