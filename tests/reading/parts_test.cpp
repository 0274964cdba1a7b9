// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/parts.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("parts of a shape come in blocks of their own", "[reading]") {
    const Script done = run(R"(#version 3.7;
        blob { threshold 0.5 sphere { x, 2, 3 } cylinder { 0, y, 1, strength 2 }
               component 1 2 <0, 0, 3> })");
    CHECK(done.text.empty());
    const Blob& blob = *done.shape<Shared<Blob>>();
    REQUIRE(blob.spheres.size() == 1);
    CHECK(blob.spheres[0].radius == 2);
    CHECK(blob.spheres[0].strength == 3);
    REQUIRE(blob.cylinders.size() == 1);
    CHECK(blob.cylinders[0].cap == Vec3(0, 1, 0));
    REQUIRE(blob.components.size() == 1);
    CHECK(blob.components[0].centre == Vec3(0, 0, 3));
}

TEST_CASE("what is wrong in a part is told of once", "[reading]") {
    CHECK(complaint("blob { sphere { 0 } }").starts_with("error"));
    CHECK(complaint("blob { sphere { 0, 1, 1 radius 2 } }").starts_with("error"));
}

TEST_CASE("textures of parts are dumped, and read back as the same", "[reading]") {
    const auto [script, texture] = GENERATE(table<std::string, std::string>({
        {"blob { sphere { 0, 1, 1 texture { pigment { rgb x } } } sphere { x, 1, 1 } scale 2 }",
         "sphere { 0, 1, 1 texture { pigment { rgb <1, 0, 0> } } } sphere { <1, 0, 0>, 1, 1 }"},
        {"blob { sphere { 0, 1, 1 pigment { gradient x } translate y } scale 2 }", "gradient"},
        {"mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 2, texture { pigment { rgb x } } "
         "texture { pigment { rgb y } } } face_indices { 3, <0,1,2>, 0, <0,1,2>, 0, 1, 1, "
         "<0,1,2> } translate z }",
         "<0, 1, 2>, 0, <0, 1, 2>, 0, 1, 1, <0, 1, 2> }"},
        {"mesh { triangle { 0, x, y texture { pigment { rgb y } } } triangle { 0, x, z } "
         "interior_texture { pigment { rgb 0.5 } } }",
         "texture_list { 1, texture { pigment { rgb <0, 1, 0> } } }"},
    }));
    INFO(script);
    const std::string once = dump(run("#version 3.7;\n" + script).scene);
    CHECK(once.find(texture) != std::string::npos);
    const Script again = run(once);
    CHECK(again.text.empty());
    CHECK(dump(again.scene) == once);
}

}  // namespace candelabra
