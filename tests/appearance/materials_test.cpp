// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/materials.h"

#include "support/spheres.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a material is a texture with an interior", "[appearance]") {
    const Script done =
        sphere_with("material { M scale 3 }",
                    "#declare M = material { texture { pigment { bozo } } interior { ior 1.5 } }");
    CHECK(done.object().interior->ior == 1.5);
    CHECK(done.texture().pigment.transform.point(Vec3(1)) == Vec3(3));
}

TEST_CASE("a material has an inner texture, which does not move with it", "[appearance]") {
    const Script done = sphere_with("material { M scale 3 }",
                                    "#declare M = material { texture { pigment { rgb 1 } } "
                                    "interior_texture { pigment { bozo } } }");
    const Handle<PartTextures>& parts = done.object().part_textures;
    REQUIRE(parts);
    CHECK(parts->interior->pigment.transform.point(Vec3(1)) == Vec3(1));
}

TEST_CASE("inner textures lie on each other, also on that of a declared material", "[appearance]") {
    const std::string two =
        "interior_texture { pigment { rgb 1 } } "
        "interior_texture { pigment { rgbt 0.5 } }";
    const auto inner = [](const Script& done) { return done.object().part_textures->interior; };
    CHECK(inner(sphere_with(two))->below);
    CHECK(inner(sphere_with("material { texture { } " + two + " }"))->below);
    CHECK(inner(sphere_with("material { M interior_texture { pigment { rgbt 0.5 } } }",
                            "#declare M = material { texture { } interior_texture { } }"))
              ->below);
}

}  // namespace candelabra
