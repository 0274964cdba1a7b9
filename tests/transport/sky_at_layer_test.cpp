// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sky_at_layer.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

TEST_CASE("directions to the sky come as often as their density says, and bring its light",
          "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; global_settings { assumed_gamma 1 } plane { y, 0 pigment { rgb 0.8 } finish "
        "{ ambient 0 diffuse 0.5 } } sky_sphere { pigment { rgb 2 } luminaire }");
    const World& world = *shot.world;
    const Ray ray{Vec3(0.3, 3, 0), Vec3(0, -1, 0)};
    Hit hit;
    REQUIRE(world.first_hit(ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(world, ray, hit);
    const auto textures = visible_textures(world, vertex);
    const Bsdf bsdf(with_layer(world, vertex, textures.front().layers.front()),
                    shading_rules(world));
    const LitLayer layer{vertex, bsdf, all_light};
    LightLedger ledger;
    const ArrivingLight at{world, layer, false, ledger};
    constexpr int count = 4000;
    double high = 0, said = 0;
    Rgb sum(0);
    for (int i = 0; i < count; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        const SkyAtLayer sky(at, key);
        const auto direction = sky.draw();
        REQUIRE(direction);
        if (direction->y > 0.7) high += 1.0 / count;
        // Directions with a height above 0.7, uniformly.
        const double height = 0.7 + 0.3 * (i + 0.5) / count, turn = 2.399963 * i,
                     across = std::sqrt(1 - height * height);
        said += 2 * std::numbers::pi * 0.3 / count *
                sky.density({across * std::cos(turn), height, across * std::sin(turn)});
        const Rgb response = layer.response(*direction, key);
        if (response == Rgb(0)) continue;
        sum += sky.from(*direction, response / (std::numbers::pi * sky.density(*direction)));
    }
    CHECK(high == Approx(said).epsilon(0.05));
    CHECK((sum / static_cast<double>(count)).r == Approx(0.8 * 0.5 * 2).epsilon(0.02));
    CHECK(ledger.shadow > 0);
}

}  // namespace candelabra
