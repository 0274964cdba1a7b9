// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace candelabra {

namespace {

std::string glowing(const std::string& strength) {
    return R"({"extensionsUsed": ["KHR_materials_emissive_strength"], "meshes": [{"primitives":
        [{"attributes": {"POSITION": 0}, "indices": 1, "material": 1}]}], "materials": [
        {"name": "Unused"}, {"name": "Lamp", "emissiveFactor": [1, 0.5, 0.25], "extensions":
        {"KHR_materials_emissive_strength": {"emissiveStrength": )" +
           strength + "}}}]}";
}

std::array<double, 3> emission(const std::string& name, const std::string& bytes) {
    for (const ImportedMaterial& material : imported(name, bytes).model.materials)
        if (material.name == "Lamp") return material.emission;
    return {-1, -1, -1};
}

}  // namespace

TEST_CASE("emission of glTF has its strength", "[imports]") {
    const std::array<double, 3> lit{40, 20, 10}, unlit{0, 0, 0}, plain{1, 0.5, 0.25};
    CHECK(emission("a.gltf", gltf(glowing("40"))) == lit);
    CHECK(emission("a.glb", glb(glowing("40"))) == lit);
    CHECK(emission("a.gltf", gltf(glowing("\"much\""))) == plain);
    CHECK(emission("a.gltf", gltf(glowing("-3"))) == unlit);
}

TEST_CASE("pictures that are moved on a surface have their own coordinates", "[imports]") {
    const double turn = 0.3, width = 2, height = 0.5, u0 = 0.25, v0 = 0.125;
    const Imported done = imported("a.gltf", gltf(R"({
        "extensionsUsed": ["KHR_texture_transform"],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {
            "KHR_texture_transform": {"offset": [0.25, 0.125], "rotation": 0.3, "scale": [2, 0.5]}}}}}],
        "textures": [{"source": 0}], "images": [{"uri": "a.ppm"}]})"));
    REQUIRE(done.problem.empty());
    const auto& uvs = done.model.meshes.at(0).uvs;
    const std::vector<std::array<double, 2>> corners = {{0, 1}, {1, 1}, {0, 0}};
    REQUIRE(uvs.size() == corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // By the specification; v of the file is downwards.
        const double u = width * corners[i][0], v = height * corners[i][1];
        INFO(i << ": " << uvs[i][0] << ' ' << uvs[i][1]);
        CHECK(uvs[i][0] == Approx(std::cos(turn) * u + std::sin(turn) * v + u0).margin(1e-5));
        CHECK(1 - uvs[i][1] == Approx(std::cos(turn) * v - std::sin(turn) * u + v0).margin(1e-5));
    }
}

TEST_CASE("measured lights of glTF have their files, factors and places", "[imports]") {
    const std::string nodes = R"("extensionsUsed": ["EXT_lights_ies"], "nodes": [
        {"name": "Root", "mesh": 0, "children": [1, 2, 3, 4]},
        {"name": "A", "translation": [1, 2, 3], "extensions": {"EXT_lights_ies": {"light": 0}}},
        {"name": "B", "extensions": {"EXT_lights_ies":
            {"light": 1, "multiplier": 2, "color": [1, 0.5, 0.25]}}},
        {"name": "C", "extensions": {"EXT_lights_ies": {"light": 7}}},
        {"name": "D", "extensions": {"EXT_lights_ies": {"light": 2}}}],
        "extensions": {"EXT_lights_ies": {"lights": [{"uri": "a.ies"},
            {"uri": "data:application/x-ies-lm-63;base64,SUVTTkE="}, {"bufferView": 2}]}})";
    const Imported done = imported("a.gltf", gltf("{" + nodes + "}"));
    REQUIRE(done.problem.empty());
    REQUIRE(done.model.profiles.size() == 3);
    CHECK(done.model.profiles[0].file == "a.ies");
    CHECK(done.model.profiles[1].bytes == "IESNA");
    CHECK(done.model.profiles[2].bytes.size() == 6);  // the corners of the triangle
    CHECK(imported("a.glb", glb("{" + nodes + "}")).model.profiles.at(2).bytes.size() == 6);
    REQUIRE(done.model.lights.size() == 3);
    CHECK(done.model.lights[0].kind == ImportedLight::measured);
    CHECK(done.model.lights[1].colour == std::array{2.0, 1.0, 0.5});
    std::vector<std::string> homes;
    for (const ImportedNode& node : done.model.nodes)
        if (node.light >= 0)
            homes.push_back(done.model.nodes.at(static_cast<std::size_t>(node.parent)).name);
    CHECK(homes == std::vector<std::string>{"A", "B", "D"});
}

}  // namespace candelabra
