// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/textures.h"

#include "evaluate/script.h"

#include <catch2/catch.hpp>

namespace {

Script sphere(const std::string& look, const std::string& before = {}) {
    Script done = run("#version 3.7; " + before + " sphere { 0, 1 " + look + " }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    return done;
}

Finish finish_of(const std::string& text) {
    return sphere("finish { " + text + " }", "#declare F = finish { ambient 1 phong 0.5 }")
        .texture()
        .finish;
}

}  // namespace

TEST_CASE("a texture starts from the default one", "[evaluate]") {
    const Script done = sphere("texture { finish { ambient 1 } }",
                               "#default { pigment { rgb 1 } finish { diffuse 0.1 } }");
    CHECK(done.texture().pigment.colour.rgb == Vec3(1));
    CHECK(done.texture().finish.ambient == Vec3(1));
    CHECK(done.texture().finish.diffuse == 0.1);
}

TEST_CASE("an object without a texture has the default one of its own time", "[evaluate]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 } #default { pigment { rgb 1 } } sphere { 0, 1 } sphere { "
            "0, 1 }");
    CHECK(done.texture(0).pigment.colour.rgb == Vec3(0));
    CHECK(done.texture(1).pigment.colour.rgb == Vec3(1));
    CHECK(done.object(1).texture == done.object(2).texture);
}

TEST_CASE("pigment and finish of an object change its texture, in turn", "[evaluate]") {
    const std::string declared =
        "#declare T = texture { pigment { rgb 0.5 } finish { ambient 0.7 } }";
    const Script done = sphere(
        "texture { T } pigment { rgb 1 } finish { diffuse 0.3 } finish { phong 1 }", declared);
    CHECK(done.texture().pigment.colour.rgb == Vec3(1));
    CHECK(done.texture().finish.ambient == Vec3(0.7));
    CHECK(done.texture().finish.diffuse == 0.3);
    CHECK(done.texture().finish.phong == 1);
    const Script parts = sphere("texture { P F }",
                                "#declare P = pigment { rgb 1 } #declare F = finish { ambient 1 }");
    CHECK(parts.texture().pigment.colour.rgb == Vec3(1));
    CHECK(parts.texture().finish.ambient == Vec3(1));
}

TEST_CASE("a declared texture is shared until it is changed", "[evaluate]") {
    const Script done =
        run("#version 3.7; #declare T = texture { pigment { checker } } "
            "sphere { 0, 1 texture { T } } sphere { 1, 1 texture { T } } sphere { 1, 1 texture { T "
            "scale 2 } }");
    CHECK(done.object(0).texture == done.object(1).texture);
    CHECK(done.object(1).texture != done.object(2).texture);
    CHECK(done.texture(2).pigment.transform.point(Vec3(1)) == Vec3(2));
}

TEST_CASE("a finish has its words, and may be declared", "[evaluate]") {
    CHECK(finish_of("ambient 0.2 diffuse 0.3 emission rgb <1, 2, 3> brilliance 2").emission ==
          Vec3(1, 2, 3));
    CHECK(finish_of("F phong_size 10").phong == 0.5);
    CHECK(finish_of("F phong_size 10").phong_size == 10);
    CHECK(finish_of("specular 1 metallic").metallic == 1);
    CHECK(finish_of("metallic specular 1").specular == 1);
    CHECK(finish_of("metallic 0.25").metallic == 0.25);
    CHECK(finish_of("conserve_energy").conserve_energy);
}

TEST_CASE("reflection is an amount or a block", "[evaluate]") {
    const Reflection amount = finish_of("reflection 0.5").reflection;
    CHECK(amount.least == Vec3(0.5));
    CHECK(amount.greatest == Vec3(0.5));
    CHECK(finish_of("reflection rgb <1, 0, 0> phong 1").reflection.greatest == Vec3(1, 0, 0));
    const Reflection both = finish_of("reflection { 0.1, rgb 0.9 falloff 3 metallic }").reflection;
    CHECK(both.least == Vec3(0.1));
    CHECK(both.greatest == Vec3(0.9));
    CHECK(both.falloff == 3);
    CHECK(both.metallic == 1);
    const Reflection fresnel = finish_of("reflection { 0.8 fresnel }").reflection;
    CHECK(fresnel.least == Vec3(0));
    CHECK(fresnel.greatest == Vec3(0.8));
    CHECK(fresnel.fresnel);
}

TEST_CASE("an interior adds up", "[evaluate]") {
    CHECK(sphere("interior { ior 1.5 }").object().interior->ior == 1.5);
    CHECK(sphere("interior { I }", "#declare I = interior { ior 1.3 }").object().interior->ior ==
          1.3);
    CHECK(sphere("interior { ior 2 } interior { }").object().interior->ior == 2);
}

TEST_CASE("an opaque texture covers another; layers that show are not available", "[evaluate]") {
    const std::string glass = "texture { pigment { rgbt 0.5 } }";
    const std::string red = "texture { pigment { rgb x } }";
    CHECK(sphere(glass + red).texture().pigment.colour.rgb == Vec3(1, 0, 0));
    const std::string layers =
        "error not-implemented: layers of textures are not available in this version";
    CHECK(complaint("sphere { 0, 1 " + red + glass + " }") == layers);
    CHECK(complaint("#declare T = " + red + glass) == layers);
    CHECK(complaint("sphere { 0, 1 texture { finish { reflection 1 } } " + red + " }") == layers);
    CHECK(complaint("#declare A = sphere { 0, 1 " + red + "} object { A " + glass + " }") ==
          layers);
}

TEST_CASE("wrong textures are told of once", "[evaluate]") {
    CHECK(complaint("sphere { 0, 1 texture { finish { ambiant 1 } } }") ==
          "error unknown-word: `finish` has no word `ambiant`");
    CHECK(complaint("sphere { 0, 1 texture { checker } }") ==
          "error not-implemented: `checker` is not available in this version");
    CHECK(complaint("sphere { 0, 1 finish { reflection } }") ==
          "error missing: `reflection` of `finish` needs a colour or a block");
    CHECK(complaint("sphere { 0, 1 finish { reflection \"a\" } }") ==
          "error wrong-type: `reflection` of `finish` must be a colour, but it is a string");
    CHECK(complaint("sphere { 0, 1 interior { fade_distance 1 } }") ==
          "error not-implemented: `fade_distance` is not available in this version");
    CHECK(complaint("#declare F = finish { } sphere { 0, 1 finish { phong 1 F } }") ==
          "error misplaced: what is declared must come first: it would replace all that is before "
          "it in `finish`");
}
