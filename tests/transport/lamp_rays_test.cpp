// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lamp_rays.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <array>
#include <numbers>

namespace candelabra {

TEST_CASE("rays of lamps have the area of each, whichever is brighter", "[transport]") {
    const SharedWorld world = world_of(
        "#version 3.7; plane { y, 0 } #default { pigment { rgb 1 } } "
        "sphere { 3*y, 0.5 finish { emission 10 } } sphere { 6*y, 1 finish { emission 0.1 } }");
    const LampRays rays(*world);
    REQUIRE(rays.any());
    std::array<double, 2> area{};
    constexpr std::uint32_t count = 20000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto drawn = rays.draw({7, i, 0, 0}, 1.0 / count, [](const Luminaire&) { return 0; });
        REQUIRE(drawn);
        CHECK(drawn->path.throughput == Rgb(1));
        area.at(drawn->light) += drawn->power_of_one;
    }
    CHECK(area[0] == Approx(std::numbers::pi).epsilon(0.02));
    CHECK(area[1] == Approx(4 * std::numbers::pi).epsilon(0.05));
    CHECK_FALSE(LampRays(*world_of("#version 3.7; plane { y, 0 }")).any());
}

}  // namespace candelabra
