// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/part_looks.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The textures of a mesh of triangles, of which each has this text behind its corners.
std::vector<Handle<Texture>> looks_of(const std::vector<std::string>& triangles) {
    std::string text = "#version 3.7; mesh {";
    for (const std::string& each : triangles) text += " triangle { 0, x, y " + each + " }";
    const Script done = run(text + " }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    const Handle<PartTextures>& parts = done.object().part_textures;
    return parts ? parts->list : std::vector<Handle<Texture>>();
}

}  // namespace

TEST_CASE("parts with equal textures share one, parts without a texture have none",
          "[appearance]") {
    CHECK(looks_of({"", ""}).empty());
    CHECK(looks_of({"pigment { rgb 1 }", "", "pigment { rgb 1 }"}).size() == 1);
    CHECK(looks_of({"pigment { rgb 1 }", "pigment { rgb 0.5 }"}).size() == 2);
}

TEST_CASE("a part begins with the default texture, and not with that of the part before it",
          "[appearance]") {
    const auto looks = looks_of({"pigment { rgb 1 } finish { phong 1 }", "pigment { rgb 1 }"});
    REQUIRE(looks.size() == 2);
    CHECK(looks[0]->finish.phong == 1);
    CHECK(looks[1]->finish.phong == 0);
}

TEST_CASE("the texture of a part is moved with it where it has a pattern", "[appearance]") {
    const Script done = run(
        "#version 3.7; blob { threshold 0.5 sphere { 0, 1, 1 pigment { checker } translate 3*x } "
        "sphere { 0, 1, 1 pigment { checker } } }");
    INFO(done.text);
    REQUIRE(done.object().part_textures);
    CHECK(done.object().part_textures->list.size() == 2);
}

}  // namespace candelabra
