// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("materials of glTF have their base colour, facets and pictures", "[imports]") {
    const Imported done = imported("a.gltf", gltf(R"({
        "materials": [{"name": "Brass", "alphaMode": "BLEND", "emissiveFactor": [1, 0.5, 0],
            "emissiveTexture": {"index": 1}, "normalTexture": {"index": 0, "scale": 0.5},
            "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 0.75],
                "metallicFactor": 0.5, "roughnessFactor": 0.25, "baseColorTexture": {"index": 0},
                "metallicRoughnessTexture": {"index": 1}}}],
        "textures": [{"source": 0}, {"source": 1}],
        "images": [{"uri": "a.png"}, {"uri": "data:image/png;base64,QUJD"}]})"));
    REQUIRE(done.problem.empty());
    const ImportedMaterial& brass = done.model.materials.at(0);
    CHECK(brass.name == "Brass");
    CHECK(brass.colour == std::array<double, 3>{0.5, 0.25, 0.125});
    CHECK(brass.opacity == 0.75);
    CHECK(brass.facets);
    CHECK(brass.metallic == 0.5);
    CHECK(brass.roughness == 0.25);
    CHECK(brass.emission == std::array<double, 3>{1, 0.5, 0});
    CHECK(brass.normal_picture >= 0);
    CHECK(brass.normal_scale == 0.5);
    const auto picture = [&](int number) {
        return done.model.pictures.at(static_cast<std::size_t>(number));
    };
    CHECK(picture(brass.picture).file == "a.png");
    CHECK(picture(brass.emission_picture).bytes == "ABC");
    CHECK(brass.facet_picture == brass.emission_picture);
    CHECK(done.model.pictures.size() == 2);
    CHECK(done.asked.empty());
}

TEST_CASE("opaque materials of glTF do not use alpha", "[imports]") {
    const Imported done = imported("a.gltf", gltf(R"({"materials": [
        {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}}]})"));
    CHECK(done.model.materials.at(0).opacity == 1);
    CHECK_FALSE(done.model.materials.at(0).uses_alpha);
}

TEST_CASE("materials of glTF that are cut out have a limit of alpha", "[imports]") {
    const auto cutoff = [](const std::string& words) {
        const Imported done = imported("a.gltf", gltf("{\"materials\": [{" + words + "}]}"));
        return done.model.materials.at(0).cutoff;
    };
    CHECK(cutoff(R"("alphaMode": "MASK")") == 0.5);
    CHECK(cutoff(R"("alphaMode": "MASK", "alphaCutoff": 0.25)") == 0.25);
    CHECK(cutoff(R"("alphaMode": "BLEND")") < 0);
    CHECK(cutoff("") < 0);
}

TEST_CASE("meshes without a material have none", "[imports]") {
    const Imported done = imported("a.gltf", gltf(R"({"materials": null, "meshes": [
        {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]})"));
    REQUIRE(done.problem.empty());
    CHECK(done.model.meshes.at(0).material == -1);
}

}  // namespace candelabra
