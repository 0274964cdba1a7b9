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

TEST_CASE("what is wrong in `replace` is said", "[objects]") {
    const auto said = [](const std::string& words) {
        const Script done = with_model("model { file \"a.glb\" " + words + " }");
        REQUIRE_FALSE(done.said.empty());
        return done.said[0].message;
    };
    CHECK(said("replace") == "`replace` needs the name of a material of the model");
    CHECK(said("replace \"Paint\"") == "`replace` needs a texture or a material behind the name");
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
