// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/textures.h"

#include "support/spheres.h"
#include "surface/normal_map.h"
#include "surface/texture_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a texture starts from the default one", "[appearance]") {
    const Script done = sphere_with("texture { finish { ambient 1 } }",
                                    "#default { pigment { rgb 1 } finish { diffuse 0.1 } }");
    CHECK(done.texture().pigment.colour.rgb == Rgb(1));
    CHECK(done.texture().finish.ambient == Rgb(1));
    CHECK(done.texture().finish.diffuse == 0.1);
}

TEST_CASE("an object without a texture has the default one of its own time", "[appearance]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 } #default { pigment { rgb 1 } } sphere { 0, 1 } sphere { "
            "0, 1 }");
    CHECK(done.texture(0).pigment.colour.rgb == Rgb(0));
    CHECK(done.texture(1).pigment.colour.rgb == Rgb(1));
    CHECK(done.object(1).texture == done.object(2).texture);
}

TEST_CASE("pigment and finish of an object change its texture, in turn", "[appearance]") {
    const std::string declared =
        "#declare T = texture { pigment { rgb 0.5 } finish { ambient 0.7 } }";
    const Script done = sphere_with(
        "texture { T } pigment { rgb 1 } finish { diffuse 0.3 } finish { phong 1 }", declared);
    CHECK(done.texture().pigment.colour.rgb == Rgb(1));
    CHECK(done.texture().finish.ambient == Rgb(0.7));
    CHECK(done.texture().finish.diffuse == 0.3);
    CHECK(done.texture().finish.phong == 1);
    const Script parts = sphere_with(
        "texture { P F }", "#declare P = pigment { rgb 1 } #declare F = finish { ambient 1 }");
    CHECK(parts.texture().pigment.colour.rgb == Rgb(1));
    CHECK(parts.texture().finish.ambient == Rgb(1));
}

TEST_CASE("a declared texture is shared until it is changed", "[appearance]") {
    const Script done =
        run("#version 3.7; #declare T = texture { pigment { checker } } "
            "sphere { 0, 1 texture { T } } sphere { 1, 1 texture { T } } sphere { 1, 1 texture { T "
            "scale 2 } }");
    CHECK(done.object(0).texture == done.object(1).texture);
    CHECK(done.object(1).texture != done.object(2).texture);
    CHECK(done.texture(2).pigment.transform.point(Vec3(1)) == Vec3(2));
}

TEST_CASE("an opaque texture covers another; others show what is below", "[appearance]") {
    const std::string glass = "texture { pigment { rgbt 0.5 } }";
    const std::string red = "texture { pigment { rgb x } }";
    CHECK(sphere_with(glass + red).texture().pigment.colour.rgb == Rgb(1, 0, 0));
    CHECK_FALSE(sphere_with(glass + red).texture().below);
    const Script layers = sphere_with(red + glass + glass);
    REQUIRE(layers.texture().below);
    REQUIRE(layers.texture().below->below);
    CHECK(layers.texture().below->below->pigment.colour.rgb == Rgb(1, 0, 0));
    CHECK(sphere_with("texture { T scale 2 }", "#declare T = " + red + glass).texture().below);
    CHECK(sphere_with("texture { finish { reflection 1 } }" + red).texture().below);
}

TEST_CASE("textures in a row that a macro gives are layers of one that is declared", "[appearance]") {
    const std::string macro =
        "#macro M() texture { pigment { rgb x } } texture { pigment { rgbt <0, 1, 0, 0.5> } } "
        "texture { pigment { rgbt <0, 0, 1, 0.5> } } #end ";
    for (const char* declared : {"#declare T = M();", "#declare T = M()",
                                 "#declare T = texture { pigment { rgb 1 } } "
                                 "#declare T = M(); #declare T = T;"}) {
        INFO(declared);
        const Script done = sphere_with("texture { T }", macro + declared);
        CHECK(done.text.empty());
        REQUIRE(done.texture().below);
        REQUIRE(done.texture().below->below);
        CHECK(done.texture().pigment.colour.rgb == Rgb(0, 0, 1));
        CHECK(done.texture().below->below->pigment.colour.rgb == Rgb(1, 0, 0));
    }
    const Script element =
        sphere_with("texture { A[0] }", macro + "#declare A = array[1]; #declare A[0] = M();");
    CHECK(element.texture().below);
}

TEST_CASE("textures behind a call that gives one are layers of what is declared", "[appearance]") {
    const std::string macro =
        "#macro M(C) texture { pigment { rgb C } } #end "
        "#macro P() pigment { rgb x } #end #declare C = z; ";
    const std::string glass = "texture { pigment { rgbt <0, 1, 0, 0.5> } }";
    const Script done = sphere_with("texture { T }", macro + "#declare T = M(x) " + glass + glass);
    CHECK(done.text.empty());
    REQUIRE(done.texture().below);
    REQUIRE(done.texture().below->below);
    CHECK(done.texture().below->below->pigment.colour.rgb == Rgb(1, 0, 0));
    // Names in a layer are resolved in the scope of the call.
    CHECK(sphere_with("texture { T }",
                      macro + "#declare T = M(x) texture { pigment { rgb C transmit 0.5 } }")
              .texture()
              .pigment.colour.rgb == Rgb(0, 0, 1));
    // The same holds within an object, but not behind a semicolon or behind other values.
    CHECK(sphere_with("#declare T = M(x) " + glass + "#declare U = 1; texture { T }", macro)
              .texture()
              .below);
    CHECK_FALSE(sphere_with("#declare T = M(x); " + glass, macro).texture().below);
    CHECK_FALSE(sphere_with("#declare T = P() " + glass, macro).texture().below);
}

TEST_CASE("blocks in a row that are no textures are not one value", "[appearance]") {
    for (const char* body : {"pigment { rgb 1 } pigment { rgb 0 }", "texture { } pigment { rgb 0 }",
                             "texture { } 1 texture { }", "sphere { 0, 1 } texture { }"}) {
        INFO(body);
        const Script done =
            run(std::string("#version 3.7; #macro M() ") + body + " #end #declare T = M();");
        CHECK(done.text.find("one value is wanted here, and this gives") != std::string::npos);
    }
}

TEST_CASE("a texture chooses from others by a pattern", "[appearance]") {
    const Script map = sphere_with(
        "texture { gradient y texture_map { [0.2 pigment { rgb 1 }] [0.8 T] } scale 2 }",
        "#declare T = texture { pigment { rgb x } }");
    const Handle<PatternedTexture>& choice = map.texture().choice;
    REQUIRE(choice);
    CHECK(choice->map.size() == 2);
    CHECK(choice->map[1].texture->pigment.colour.rgb == Rgb(1, 0, 0));
    CHECK(choice->transform.point(Vec3(1)) == Vec3(2));
    const Script list = sphere_with("texture { hexagon texture { pigment { rgb 1 } } }");
    CHECK(list.texture().choice->map.size() == 3);
    const Script tiles = sphere_with(
        "texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb y } } } }");
    CHECK(tiles.texture().choice->map[1].texture->pigment.colour.rgb == Rgb(1, 0, 0));
}

TEST_CASE("a function chooses textures", "[appearance]") {
    const Script done = sphere_with(
        "texture { function { x } texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } }");
    CHECK(std::holds_alternative<FunctionPattern>(done.texture().choice->use.pattern));
    CHECK(done.texture().choice->map.size() == 2);
}

TEST_CASE("wrong textures are told of once", "[appearance]") {
    CHECK(complaint("sphere { 0, 1 #for (I, 0, 1000) texture { pigment { rgbt 0.5 } } #end }") ==
          "error recursion-limit: a texture cannot have more than 1000 layers");
    CHECK(complaint("sphere { 0, 1 texture { finish { ambiant 1 } } }") ==
          "error unknown-word: `finish` has no word `ambiant`");
    CHECK(complaint("sphere { 0, 1 texture { checker } }") ==
          "error missing: a texture with a pattern needs a `texture_map`, or a list of textures");
    CHECK(complaint("sphere { 0, 1 texture { tiles { texture { } } } }") ==
          "error wrong-count: `tiles` needs two textures");
    CHECK(complaint("sphere { 0, 1 texture { texture_map { [0 pigment { rgb 1 }] } } }") ==
          "error misplaced: `texture_map` needs a pattern before it");
    CHECK(complaint("sphere { 0, 1 texture { checker texture { } texture { } texture { } } }") ==
          "error wrong-count: this pattern takes 2 textures, but here is one more");
}

TEST_CASE("no_bump_scale may stand anywhere in a texture", "[appearance]") {
    const std::string declared =
        "#declare T = texture { pigment { rgb 1 } normal { bumps 0.3 scale 2 } }";
    for (const std::string text :
         {"no_bump_scale normal { bumps 0.3 }", "normal { bumps 0.3 } scale 2 no_bump_scale",
          "pigment { rgb 1 } no_bump_scale normal { bumps }", "T no_bump_scale scale 3"}) {
        INFO(text);
        const Script done = sphere_with("texture { " + text + " }", declared);
        CHECK(done.texture().normal.pattern->settings.no_bump_scale);
    }
    const Script kept = sphere_with("texture { T no_bump_scale }", declared);
    CHECK(kept.texture().normal.transform.point(Vec3(1)) == Vec3(2));
    CHECK(kept.texture().normal.pattern->settings.bump_size == 0.3);
    const Script later = sphere_with("texture { no_bump_scale } normal { bumps 0.3 }");
    CHECK(later.texture().normal.pattern->settings.no_bump_scale);
    const Script layers =
        sphere_with("texture { L no_bump_scale }",
                    declared +
                        "#declare L = texture { T } texture { pigment { rgbt 0.5 } normal "
                        "{ bumps } }");
    CHECK(layers.texture().normal.pattern->settings.no_bump_scale);
    CHECK_FALSE(layers.texture().below->normal.pattern->settings.no_bump_scale);
    CHECK(complaint("sphere { 0, 1 texture { checker texture { } texture { } no_bump_scale } }") ==
          "warning no-effect: `no_bump_scale` has no effect in a texture that chooses by a "
          "pattern");
}

}  // namespace candelabra
