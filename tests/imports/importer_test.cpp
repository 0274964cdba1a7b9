// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"
#include "support/models.h"

#include <catch2/catch.hpp>

#include <algorithm>

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

TEST_CASE("cameras of glTF belong to all of their nodes", "[imports]") {
    const Imported done = imported("a.gltf", gltf(R"({"nodes": [
        {"name": "Root", "mesh": 0, "children": [1, 2, 3]},
        {"name": "Near", "camera": 0, "translation": [1, 2, 3]}, {"name": "Far", "camera": 0},
        {"camera": 1}], "cameras": [
        {"name": "Wide", "type": "perspective",
         "perspective": {"yfov": 1.57079633, "aspectRatio": 3, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 9}}]})"));
    REQUIRE(done.problem.empty());
    const ImportedModel& model = done.model;
    REQUIRE(model.nodes.size() == 4);
    CHECK(model.nodes[0].camera < 0);
    CHECK(model.nodes[1].name == "Near");
    const auto camera = [&](std::size_t node) {
        return model.cameras.at(static_cast<std::size_t>(model.nodes[node].camera));
    };
    for (const std::size_t node : {1, 2}) {
        CHECK(camera(node).name == "Wide");
        CHECK(camera(node).height == Approx(2));
        CHECK_FALSE(camera(node).parallel);
        CHECK(camera(node).location == std::array<double, 3>{0, 0, 0});
    }
    CHECK(camera(3).parallel);
    CHECK(camera(3).height == 4);
}

TEST_CASE("cameras of Collada and FBX have their angles and directions", "[imports]") {
    const auto camera_of = [](const std::string& name, const std::string& file) {
        const Imported done = imported(name, file);
        INFO(name << ": " << done.problem);
        REQUIRE(done.model.cameras.size() == 1);
        const auto node = std::ranges::find(done.model.nodes, 0, &ImportedNode::camera);
        REQUIRE(node != done.model.nodes.end());
        CHECK(node->transform[3] == 1);
        CHECK(node->transform[11] == 3);
        return done.model.cameras[0];
    };
    const auto of_optics = [&](const std::string& optics) {
        return camera_of("a.dae", dae_of_camera(optics));
    };
    const ImportedCamera wide =
        of_optics("<perspective><xfov>90</xfov><aspect_ratio>2</aspect_ratio></perspective>");
    CHECK(wide.height == Approx(1));
    CHECK(wide.width == 0);
    CHECK(wide.direction == std::array<double, 3>{0, 0, -1});
    CHECK(of_optics("<perspective><yfov>90</yfov></perspective>").height == Approx(2));
    CHECK(of_optics("<perspective><xfov>90</xfov></perspective>").width == Approx(2));
    const ImportedCamera parallel =
        of_optics("<orthographic><xmag>3</xmag><aspect_ratio>1.5</aspect_ratio></orthographic>");
    CHECK(parallel.parallel);
    CHECK(parallel.height == Approx(4));
    CHECK(of_optics("<orthographic><ymag>2</ymag></orthographic>").height == Approx(4));
    CHECK(of_optics("<orthographic><xmag>3</xmag></orthographic>").width == Approx(6));
    const ImportedCamera turned = camera_of("a.fbx", fbx_of_camera());
    CHECK(turned.height == Approx(1.5));
    CHECK(turned.direction == std::array<double, 3>{1, 0, 0});
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
