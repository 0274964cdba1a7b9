// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/cutaway.h"

#include "support/script.h"
#include "surface/texture_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The colour at a point on one part of the scene's only object.
Rgb colour(const Script& script, std::size_t part, const Vec3& point) {
    const Handle<Texture> texture = std::get<Union>(script.object(0).form).children[part]->texture;
    if (!texture) return Rgb(-1);
    Rgb sum(0);
    for_layers(*texture, point, Vec3(0, 1, 0), PatternScene{},
               [&](double weight, std::span<const Layer> layers) {
                   sum += weight * layers.front().colour.rgb;
               });
    return sum;
}

const Rgb red(1, 0, 0), green(0, 1, 0), none(-1);

}  // namespace

TEST_CASE("a difference shows its first part where it is cut", "[objects]") {
    const Script done =
        run("#version 3.7; difference { box { -1, 1 pigment { rgb <1, 0, 0> } } sphere { 1, 1 } "
            "sphere { -1, 1 pigment { rgb <0, 1, 0> } } cutaway_textures }");
    CHECK(done.said.empty());
    CHECK(colour(done, 0, Vec3(0)) == red);
    CHECK(colour(done, 1, Vec3(0)) == red);
    CHECK(colour(done, 2, Vec3(0)) == green);
}

TEST_CASE("an intersection shows the mean of its other parts", "[objects]") {
    const Script done =
        run("#version 3.7; intersection { box { -1, 1 pigment { rgb <1, 0, 0> } } sphere { 0, 1.2 "
            "pigment { rgb <0, 1, 0> } } sphere { 0.1, 1 } plane { y, 0 } cutaway_textures }");
    CHECK(colour(done, 2, Vec3(0)) == Rgb(0.5, 0.5, 0));
    CHECK(colour(done, 3, Vec3(0)) == Rgb(0.5, 0.5, 0));
}

TEST_CASE("of a union it is the parts that contain the point", "[objects]") {
    const Script done =
        run("#version 3.7; difference { union { box { -1, 0.5 pigment { rgb <1, 0, 0> } } sphere { "
            "0.5, "
            "1 pigment { rgb <0, 1, 0> } } translate x } sphere { 0, 9 } cutaway_textures }");
    CHECK(colour(done, 0, Vec3(0)) == none);
    CHECK(colour(done, 1, Vec3(0.2, -0.9, -0.9)) == red);
    CHECK(colour(done, 1, Vec3(2, 1, 1)) == green);
    CHECK(colour(done, 1, Vec3(1.4, 0.4, 0.4)) == Rgb(0.5, 0.5, 0));
}

TEST_CASE("cutaway_textures changes nothing where there is a texture for the whole", "[objects]") {
    const Script whole =
        run("#version 3.7; difference { box { -1, 1 pigment { rgb <1, 0, 0> } } sphere { 1, 1 } "
            "cutaway_textures pigment { rgb 1 } }");
    CHECK(colour(whole, 1, Vec3(0)) == none);
    const Script first =
        run("#version 3.7; difference { box { -1, 1 } sphere { 1, 1 pigment { rgb 1 } } "
            "cutaway_textures }");
    CHECK(colour(first, 0, Vec3(0)) == none);
}

TEST_CASE("parts that consist of parts show the textures as single ones do", "[objects]") {
    const std::string balls = "{ sphere { 0, 1 } sphere { x, 1 } ";
    for (const std::string& cutter : std::vector<std::string>{
             "union " + balls + "}", "merge " + balls + "}", "intersection " + balls + "}",
             "union " + balls + "translate y }", "union { union " + balls + "} sphere { z, 1 } }",
             "union { merge " + balls + "rotate 30*z } }", "object { Declared }",
             "object { Declared rotate 50*x }", "union { difference " + balls + "} box { 0, 1 } }"})
        for (const std::string whole :
             {"difference { box { -1, 1 pigment { rgb <1, 0, 0> } } ",
              "intersection { box { -1, 1 pigment { rgb <1, 0, 0> } } "}) {
            CAPTURE(cutter, whole);
            const Script done = run("#version 3.7; #declare Declared = union " + balls + "} " +
                                    whole + cutter + " cutaway_textures }");
            CHECK(done.said.empty());
            CHECK(colour(done, 0, Vec3(0)) == red);
            CHECK(colour(done, 1, Vec3(0)) == red);
        }
}

TEST_CASE("textures of parts within a part end the search", "[objects]") {
    const Script done = run(
        "#version 3.7; difference { box { -1, 1 pigment { rgb <1, 0, 0> } } union { sphere { 0, "
        "1 pigment { rgb <0, 1, 0> } } sphere { x, 1 } difference { sphere { y, 1 pigment { rgb "
        "<0, 1, 0> } } sphere { z, 1 } } } cutaway_textures }");
    CHECK(colour(done, 1, Vec3(0)) == red);
    const auto& parts = std::get<Union>(std::get<Union>(done.object(0).form).children[1]->form);
    REQUIRE(parts.children.size() == 3);
    CHECK(parts.children[0]->texture != nullptr);
    CHECK(parts.children[1]->texture == nullptr);
    // A cut shows its own parts first.
    const auto& cut = std::get<Union>(parts.children[2]->form);
    CHECK(cut.children[1]->texture != nullptr);
    const Script whole = run(
        "#version 3.7; difference { box { -1, 1 pigment { rgb <1, 0, 0> } } union { sphere { 0, "
        "1 } sphere { x, 1 } pigment { rgb <0, 1, 0> } } cutaway_textures }");
    CHECK(colour(whole, 1, Vec3(0)) == green);
}

TEST_CASE("cutaway_textures belongs to what cuts", "[objects]") {
    const Script done = run("#version 3.7; union { sphere { 0, 1 } cutaway_textures }");
    REQUIRE(done.said.size() == 1);
}

}  // namespace candelabra
