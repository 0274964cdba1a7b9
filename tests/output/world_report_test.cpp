// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/world_report.h"

#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the report tells what a world is made of") {
    Texture glow;
    glow.pigment.colour.rgb = Rgb(1);
    glow.finish.emission = Rgb(2);
    Object lamp, floor;
    lamp.form = Sphere{Vec3(0, 2, 0), 1};
    lamp.texture = make_handle<Texture>(glow);
    floor.form = Plane{};
    floor.texture = make_handle<Texture>();
    Scene scene;
    scene.objects = {make_handle<Object>(lamp), make_handle<Object>(floor)};
    scene.settings.light_sampler = EveryLight{};
    Diagnostics diagnostics;
    const std::string text = report(*compile(scene, {}, diagnostics));
    CHECK(text.find("objects: 2\n") != std::string::npos);
    CHECK(text.find("luminaires: 1 (1 spheres, 0 triangles, 0 others), greatest radiance 2\n") !=
          std::string::npos);
    CHECK(text.find("light sampler: every_light\n") != std::string::npos);
    CHECK(text.find("1 infinite\n") != std::string::npos);
    CHECK(text.find("index: kd_tree, ") != std::string::npos);
}

}  // namespace candelabra
