// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/legacy_textures.h"

#include "support/spheres.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Script old_sphere(const std::string& texture) {
    return run("#version 2.0; sphere { 0, 1 texture { " + texture + " } }");
}

}  // namespace

TEST_CASE("an old texture holds the words of its parts", "[appearance]") {
    const Script done = old_sphere("color red 1 phong 0.5 bumps 0.3 frequency 2 reflection 0.2");
    REQUIRE(done.text.empty());
    CHECK(done.texture().pigment.colour.rgb == Rgb(1, 0, 0));
    CHECK(done.texture().finish.phong == 0.5);
    CHECK(done.texture().finish.reflection.least == Rgb(0.2));
    REQUIRE(done.texture().normal.pattern);
    CHECK(done.texture().normal.pattern->settings.bump_size == 0.3);
    CHECK(old_sphere("0.1 color red 1").texture().finish.crand == 0.1);
}

TEST_CASE("what is moved in an old texture is what is there by then", "[appearance]") {
    const Script done = old_sphere("checker color red 1 color blue 1 scale 2 dents 0.5");
    REQUIRE(done.text.empty());
    CHECK(done.texture().pigment.transform.point(Vec3(1)) == Vec3(2));
    CHECK(done.texture().normal.transform.point(Vec3(1)) == Vec3(1));
    CHECK(old_sphere("scale 2 checker color red 1 color blue 1")
              .texture()
              .pigment.transform.point(Vec3(1)) == Vec3(2));
    const Script behind = old_sphere("dents 0.5 checker color red 1 color blue 1 scale 2");
    CHECK(behind.texture().normal.transform.point(Vec3(1)) == Vec3(2));
}

TEST_CASE("from version 3.0 on, the parts of a texture have blocks", "[appearance]") {
    for (const std::string word : {"color red 1", "phong 1", "bumps 0.5"}) {
        INFO(word);
        CHECK(run("#version 3.0; sphere { 0, 1 texture { " + word + " } }").text != "");
        CHECK(old_sphere("nonsense " + word).text != "");
    }
}

TEST_CASE("a number that no word of an old texture waits for is its grain", "[appearance]") {
    for (const std::string words :
         {"color red 1 0.2", "color red 1 ambient 1 0.2", "bozo turbulence 0.4 0.2",
          "bozo turbulence <1, 2, 3> 0.2", "marble 0.2 turbulence 0.4", "wood octaves 3 0.2",
          "gradient <1, 0, 0> 0.2", "checker color red 1 color blue 1 0.2", "mandel 20 0.2",
          "bozo color_map { [0 1 color red 0 color red 1] } 0.2", "color red 1 metallic 0.2",
          "color red 1 bumps 0.5 0.2", "color red 1 ripples 0.5 frequency 3 0.2",
          "bozo scale 2 0.2", "color red 1 normal { bumps 0.5 } 0.2",
          "color red 1 quick_color green 1 0.2", "granite phong 0.5 phong_size 20 0.2"}) {
        INFO(words);
        const Script done = old_sphere(words);
        INFO(done.text);
        REQUIRE(done.text.empty());
        CHECK(done.texture().finish.crand == 0.2);
    }
    CHECK(old_sphere("0.3 granite 0.1 phong 0.5 0.2").texture().finish.crand == 0.2);
    const Script done = old_sphere("bozo turbulence 0.4 octaves 3 metallic 0.1 bumps 0.3");
    REQUIRE(done.text.empty());
    CHECK(done.texture().pigment.pattern->use.modifiers.turbulence == Vec3(0.4));
    CHECK(done.texture().pigment.pattern->use.modifiers.octaves == 3);
    CHECK(done.texture().finish.metallic == 1);
    CHECK(done.texture().normal.pattern->settings.bump_size == 0.3);
    CHECK(complaint("sphere { 0, 1 pigment { bozo turbulence 0.4 0.2 } }") ==
          "error wrong-count: `turbulence` takes one vector, and a vector stands in `< >`");
}

}  // namespace candelabra
