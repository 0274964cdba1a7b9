// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_rays.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace candelabra {

TEST_CASE("rays of the sky bring its light to any place", "[transport]") {
    const SharedWorld world = world_of(
        "#version 3.7; plane { y, -2 pigment { rgb 1 } } sphere { <0, -1.5, 0>, 0.4 } sky_sphere { "
        "pigment { gradient y color_map { [0.5 rgb 0] [0.5 rgb <1, 2, "
        "4>] } scale 2 translate -1 } luminaire }");
    const LitRegion region{Vec3(0), 1, 1e5};
    const SeenPlace below{Vec3(0, -1, 0), Vec3(0, 1, 0), 1e-9};
    const std::vector<SeenPlace> floor(64, below);
    // A disc that faces the bright half gets pi times its radiance.
    for (const auto& [middle, seen] : {std::pair<Vec3, std::span<const SeenPlace>>{Vec3(0), {}},
                                       {Vec3(3, 1, 0), {}},
                                       {Vec3(0), floor},
                                       {Vec3(3, 1, 0), floor}}) {
        const SkyRays rays(*world, region, seen);
        REQUIRE(rays.power() > 0);
        Rgb sum(0);
        constexpr std::uint32_t count = 400000;
        for (std::uint32_t i = 0; i < count; ++i) {
            const SkyRays::Drawn drawn = rays.draw((i % 97 + 0.5) / 97, {7, i, 0, 0});
            const Ray& ray = drawn.ray;
            const double way = (middle.y - ray.origin.y) / ray.direction.y;
            if (ray.direction.y < 0 && length(ray.at(way) - middle) < 0.8)
                sum += drawn.power / static_cast<double>(count);
        }
        const double area = std::numbers::pi * 0.8 * 0.8;
        CAPTURE(middle.x, seen.size());
        CHECK(sum.r == Approx(area).epsilon(0.05));
        CHECK(sum.b == Approx(4 * area).epsilon(0.05));
    }
    CHECK(SkyRays(*world_of("#version 3.7; background { rgb 1 }"), region, {}).power() == 0);
}

}  // namespace candelabra
