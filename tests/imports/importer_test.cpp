// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr std::string_view nested_nodes = R"({"nodes": [
    {"name": "Root", "children": [1, 2]},
    {"name": "Left", "mesh": 0, "translation": [1, 2, 3]},
    {"name": "Right", "mesh": 0, "scale": [1, 2, 1],
     "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "color": [1, 0.5, 0.25], "intensity": 100,
         "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}}]}}})";

}  // namespace

TEST_CASE("meshes come once, with the places of each", "[imports]") {
    const Imported done = imported("a.gltf", gltf(nested_nodes));
    REQUIRE(done.problem.empty());
    const ImportedModel& model = done.model;
    REQUIRE(model.meshes.size() == 1);
    CHECK(model.meshes[0].points ==
          decltype(model.meshes[0].points){{0, 0, 0}, {2, 0, 0}, {0, 1, 0}});
    // In files v leads down, in models up.
    CHECK(model.meshes[0].uvs == decltype(model.meshes[0].uvs){{0, 0}, {1, 0}, {0, 1}});
    CHECK(model.meshes[0].faces == decltype(model.meshes[0].faces){{0, 1, 2}});
    REQUIRE(model.nodes.size() == 3);
    CHECK(model.nodes[0].parent == -1);
    CHECK(model.nodes[1].name == "Left");
    CHECK(model.nodes[1].parent == 0);
    CHECK(model.nodes[1].transform == std::array<double, 12>{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3});
    CHECK(model.nodes[1].meshes == std::vector<int>{0});
    CHECK(model.nodes[2].meshes == std::vector<int>{0});
    CHECK(model.nodes[2].light == 0);
}

TEST_CASE("lights of glTF have candela and angles", "[imports]") {
    const Imported done = imported("a.gltf", gltf(nested_nodes));
    REQUIRE(done.model.lights.size() == 1);
    const ImportedLight& light = done.model.lights[0];
    CHECK(light.kind == ImportedLight::spot);
    CHECK(light.colour == std::array<double, 3>{100, 50, 25});
    CHECK(light.inner == 0.25);
    CHECK(light.outer == 0.5);
}

TEST_CASE("binary files are read as those of text", "[imports]") {
    const Imported text = imported("a.gltf", gltf()), binary = imported("a.GLB", glb());
    REQUIRE(binary.problem.empty());
    CHECK(binary.model.meshes.at(0).points == text.model.meshes.at(0).points);
    CHECK(binary.model.materials.at(0).colour == text.model.materials.at(0).colour);
}

TEST_CASE("only readers of the file's extension see it", "[imports]") {
    CHECK(imported("a.obj", glb()).model.meshes.empty());
    CHECK_FALSE(imported("a.glb", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").problem.empty());
    CHECK_FALSE(imported("a.dae", "BLENDER-v300").problem.empty());
    CHECK_FALSE(imported("a.xyz", gltf()).problem.empty());
    CHECK_FALSE(imported("glb", gltf()).problem.empty());
}

}  // namespace candelabra
