// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/model_files.h"

#include "support/gltf.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A model with one picture in it and one beside it, of one pixel each.
std::string two_pictures() {
    const std::string picture = "data:image/x-portable-pixmap;base64," +
                                in_base64("P6 1 1 255\n\xff" + std::string(2, '\0'));
    return gltf(R"({"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
        "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 1}}],
        "textures": [{"source": 0}, {"source": 1}],
        "images": [{"uri": ")" +
                picture + R"("}, {"uri": "b.ppm"}]})");
}

Script with_picture(const std::string& words) {
    return run(
        "#version 3.7; global_settings { assumed_gamma 1 }\nsphere { 0, 1 pigment { image_map { " +
            words + " } } }",
        {{"m/a.gltf", two_pictures()}, {"m/b.ppm", std::string("P6 1 1 255\n\0\0\xff", 14)}});
}

}  // namespace

TEST_CASE("pictures of models are named by their numbers", "[appearance]") {
    const auto colour = [](const std::string& words) {
        const Script done = with_picture(words);
        INFO(done.text);
        REQUIRE(done.said.empty());
        return evaluate(done.texture().pigment, Vec3(0.5, 0.5, 0)).rgb;
    };
    CHECK(colour("\"m/a.gltf\" picture 0") == Rgb(1, 0, 0));
    CHECK(colour("\"m/a.gltf\" picture 1") == Rgb(0, 0, 1));
    CHECK(colour("\"m/a.gltf\" picture 0 tint <0.5, 1, 1>") == Rgb(0.5, 0, 0));
}

TEST_CASE("wrong numbers and files of pictures are errors", "[appearance]") {
    const auto said = [](const std::string& words) {
        const Script done = with_picture(words);
        REQUIRE(done.said.size() == 1);
        return done.said[0].message;
    };
    CHECK(said("\"m/a.gltf\" picture 2") == "there is no `picture` 2 in the model, which has 2");
    CHECK(said("\"m/b.ppm\" picture 0") ==
          "`picture` is for files of models, and `m/b.ppm` is none");
    CHECK(said("\"none.glb\" picture 0").find("none.glb") != std::string::npos);
}

TEST_CASE("profiles of models are named by their numbers", "[appearance]") {
    const std::string web =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 60\n0\n900 100\n";
    const std::string whole = gltf(R"({"extensionsUsed": ["EXT_lights_ies"], "nodes": [
        {"name": "Root", "extensions": {"EXT_lights_ies": {"light": 0}}}],
        "extensions": {"EXT_lights_ies": {"lights": [{"uri": "data:text/plain;base64,)" +
                                   in_base64(web) + "\"}]}}}");
    const auto light = [&](const std::string& words, const std::string& model) {
        return run("#version 3.7; light_source { 0, 1 " + words + " }",
                   {{"a.gltf", model}, {"a.ies", web}});
    };
    const Script inside = light("ies \"a.gltf\" profile 0 multiplier 2", whole);
    const Script beside = light("ies \"a.ies\"", whole);
    INFO(inside.text << beside.text);
    REQUIRE(inside.said.empty());
    const auto below = [](const Script& done) {
        const PointLight& lamp = done.scene.lights.at(0).light;
        return incidence(lamp, Vec3(0), Vec3(0, -1, 0)).colour.r;
    };
    CHECK(below(inside) == Approx(2 * below(beside)));
    CHECK_FALSE(light("ies \"a.gltf\" profile 0", gltf()).said.empty());
    CHECK(light("ies \"a.gltf\" profile 1", whole).said.at(0).message ==
          "there is no `profile` 1 in the model, which has 1");
}

}  // namespace candelabra
