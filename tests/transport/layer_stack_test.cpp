// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/layer_stack.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("layers are seen through those above them", "[transport]") {
    const World world = world_of(R"(sphere { 0, 1
        texture { pigment { rgb 0.5 } finish { reflection 0.3 } }
        texture { pigment { rgbt <1, 0, 0, 0.5> } }
        texture { pigment { rgbf <0.5, 1, 1, 0.8> } } })");
    PathState path;
    path.ray = {Vec3(0, 0, -3), Vec3(0, 0, 1)};
    Hit hit;
    REQUIRE(world.first_hit(path.ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(world, path.ray, hit);
    std::vector<Vec3> through, reflected;
    for_visible_layers(world, vertex, 0, [&](double, std::span<const Layer> layers) {
        const LayerStack stack(world, path, vertex, layers);
        CHECK_FALSE(stack.is_clear());  // the lowest layer is opaque
        stack.visit([&](const LayerStack::Seen& seen) {
            through.push_back(seen.through);
            reflected.push_back(seen.reflected);
        });
    });
    REQUIRE(through.size() == 3);
    CHECK(through[0] == Vec3(1));
    CHECK(length(through[1] - Vec3(0.4, 0.8, 0.8)) < 1e-6);
    CHECK(length(through[2] - Vec3(0.2, 0.4, 0.4)) < 1e-6);
    CHECK(reflected[0] == Vec3(0));
    CHECK(reflected[2] == Vec3(0.3));
}

}  // namespace candelabra
