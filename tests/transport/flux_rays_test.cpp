// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/flux_rays.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <array>

namespace candelabra {

TEST_CASE("rays of light sources have the flux of each, whichever is brighter", "[transport]") {
    const SharedWorld world = world_of(
        "#version 3.7; global_settings { photometry { unit 1 white 1 } } plane { y, 0 } "
        "light_source { 3*y, 1 flux lumen(1000) } light_source { 6*y, 1 flux lumen(10) spotlight "
        "radius 20 falloff 40 point_at 0 } light_source { 6*y, 1 } light_source { 6*y, 1 parallel "
        "point_at 0 } light_source { 6*y, 1 flux lumen(5) shadowless }");
    CHECK(sends_flux(*world, 0));
    CHECK(sends_flux(*world, 1));
    for (const std::uint32_t without : {2U, 3U, 4U}) CHECK_FALSE(sends_flux(*world, without));
    const FluxRays rays(*world);
    const LightUnits units{1, 1};
    CHECK(units.lumens(rays.light()) == Approx(1010));
    std::array<double, 2> flux{};
    constexpr std::uint32_t count = 20000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto drawn = rays.draw({7, i, 0, 0});
        REQUIRE(drawn);
        flux.at(drawn->source) += units.lumens(drawn->power.r) / count;
    }
    CHECK(flux[0] == Approx(1000).epsilon(0.01));
    CHECK(flux[1] == Approx(10).epsilon(0.25));
    CHECK(FluxRays(*world_of("#version 3.7; light_source { y, 1 }")).light() == 0);
}

}  // namespace candelabra
