// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/model_block.h"

#include "scene/dump.h"
#include "support/gltf.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Script with_model(const std::string& statements) {
    return run("#version 3.7;\n" + statements, {{"a.glb", glb()}});
}

const std::string green_text = "<0, 1, 0>", paint_text = "<0.5, 0.25, 0.125>";

}  // namespace

TEST_CASE("materials of a model are replaced by the scene's own", "[objects]") {
    for (const char* look :
         {"texture { pigment { rgb y } }", "texture { Green }", "Green",
          "material { texture { Green } interior { ior 1.5 } }", "material { Leaf }", "Leaf"}) {
        INFO(look);
        const Script done = with_model(
            "#declare Green = texture { pigment { rgb y } }\n"
            "#declare Leaf = material { texture { Green } interior { ior 1.5 } }\n"
            "model { file \"a.glb\" replace \"Paint\" " +
            std::string(look) + " scale 2 } model { file \"a.glb\" }");
        INFO(done.text);
        CHECK(done.said.empty());
        const std::string text = dump(done.scene);
        CHECK(text.find(green_text) < text.find(paint_text));
        const bool inside = std::string_view(look).find("Leaf") != std::string_view::npos ||
                            std::string_view(look).find("ior") != std::string_view::npos;
        CHECK((text.find("ior 1.5") != std::string::npos) == inside);
    }
}

TEST_CASE("parts of a model are replaced by the scene's own objects", "[objects]") {
    const std::string file = gltf(R"({"nodes": [
        {"name": "Root", "children": [1, 2, 3]},
        {"name": "Lamp", "mesh": 0, "translation": [1, 2, 3], "scale": [2, 2, 2], "children": [4]},
        {"name": "Post", "mesh": 0}, {"name": "Lamp", "mesh": 0}, {"name": "Inner", "mesh": 0}]})");
    for (const char* own : {"sphere { 0.1*z, 0.5 }", "Ball", "object { Ball }",
                            "union { object { Ball } light_source { 0, 1 } }"}) {
        INFO(own);
        const Script done =
            run("#version 3.7; #declare Ball = sphere { 0.1*z, 0.5 }\n"
                "model { file \"a.gltf\" replace \"Lamp\" " +
                    std::string(own) + " }",
                {{"a.gltf", file}});
        INFO(done.text);
        CHECK(done.said.empty());
        const std::string text = dump(done.scene);
        std::size_t balls = 0, meshes = 0;
        for (std::size_t at = 0; (at = text.find("sphere {", at)) != text.npos; ++at) ++balls;
        for (std::size_t at = 0; (at = text.find("mesh", at)) != text.npos; ++at) ++meshes;
        CHECK(balls >= 1);
        CHECK(meshes >= 1);
        const bool lit = std::string_view(own).starts_with("union");
        REQUIRE(done.scene.lights.size() == (lit ? 2 : 0));
        if (lit) CHECK(length(done.scene.lights[0].light.location - Vec3(1, 2, -3)) < 1e-12);
    }
    CHECK(run("#version 3.7; model { file \"a.gltf\" replace \"Lump\" sphere { 0, 1 } }",
              {{"a.gltf", file}})
              .said.at(0)
              .message == "the model has no part \"Lump\"");
}

TEST_CASE("what is wrong in `replace` is said", "[objects]") {
    const auto said = [](const std::string& words) {
        const Script done = with_model("model { file \"a.glb\" " + words + " }");
        REQUIRE_FALSE(done.said.empty());
        return done.said[0].message;
    };
    CHECK(said("replace") == "`replace` needs the name of a material or a part of the model");
    CHECK(said("replace \"Paint\"") ==
          "`replace` needs a texture, a material or an object behind the name");
    CHECK(said("replace \"Pant\" texture { pigment { rgb y } }") ==
          "the model has no material \"Pant\"");
}

TEST_CASE("a model is an object, and its name may be a scene's own", "[objects]") {
    const Script done = with_model(
        "#declare model = model { file \"a.glb\" }\n"
        "union { object { model translate x } model { file \"a.glb\" no_shadow } pigment { rgb y } "
        "}\n"
        "#local part = 3; model { file \"a.glb\" translate part*x texture { pigment { rgb y } } }");
    INFO(done.text);
    CHECK(done.said.empty());
    CHECK(done.scene.objects.size() == 2);
    const std::string text = dump(run(dump(done.scene)).scene);
    CHECK(text.find(paint_text) != std::string::npos);
    CHECK(dump(run(text).scene) == text);
}

}  // namespace candelabra
