// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/packed_model.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

namespace {

std::string packed(const ImportedModel& model) {
    std::string bytes(packed_size(model), '\0');
    pack(model, bytes.data());
    return bytes;
}

ImportedModel small_model() {
    ImportedModel model;
    ImportedMesh& mesh = model.meshes.emplace_back();
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.faces = {{0, 1, 2}};
    mesh.material = 0;
    ImportedMaterial& paint = model.materials.emplace_back();
    paint.name = "Paint";
    paint.picture = 0;
    model.pictures.push_back({"a.png", "bytes"});
    model.lights.emplace_back().colour = {1, 2, 3};
    ImportedNode& root = model.nodes.emplace_back();
    root.name = "Root";
    root.meshes = {0};
    model.nodes.emplace_back().parent = 0;
    model.nodes.back().light = 0;
    model.cameras.emplace_back().name = "View";
    model.nodes.back().camera = 0;
    return model;
}

/// What unpack() says of the model after a change.
template <class Change>
std::string said_of(Change change) {
    ImportedModel model = small_model();
    UnpackedModel read;
    change(model);
    return unpack(packed(model), read);
}

}  // namespace

TEST_CASE("a model is unpacked as it was packed", "[meshing]") {
    const std::string bytes = packed(small_model());
    UnpackedModel read;
    REQUIRE(unpack(bytes, read).empty());
    CHECK(read.model.materials.at(0).name == "Paint");
    CHECK(read.model.pictures.at(0).bytes == "bytes");
    CHECK(read.model.nodes.at(1).light == 0);
    CHECK(read.model.nodes.at(1).camera == 0);
    const Mesh& mesh = read.meshes.at(0);
    CHECK(mesh.vertices == std::vector<Vec3>{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(mesh.normals == std::vector<Vec3>(3, Vec3(0, 0, 1)));
    CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}});
    // The lists of the mesh have gone elsewhere; all the rest is as it was.
    ImportedModel same = small_model();
    same.meshes[0] = {};
    same.meshes[0].material = 0;
    CHECK(packed(read.model) == packed(same));
}

TEST_CASE("bytes that are cut or changed are errors or models", "[meshing]") {
    const std::string bytes = packed(small_model());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        UnpackedModel read;
        CHECK_FALSE(unpack(bytes.substr(0, size), read).empty());
        std::string other = bytes;
        other[size] = static_cast<char>(~other[size]);
        if (!unpack(other, read).empty()) continue;
        for (const Mesh& mesh : read.meshes) CHECK(problem(mesh).empty());
    }
}

TEST_CASE("indices and numbers of a model are checked", "[meshing]") {
    constexpr float endless = std::numeric_limits<float>::infinity();
    CHECK(said_of([](ImportedModel&) {}).empty());
    CHECK(said_of([](ImportedModel& m) { m.meshes[0].faces[0][1] = 3; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.meshes[0].faces[0][1] = -1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.meshes[0].normals.pop_back(); }) != "");
    CHECK(said_of([](ImportedModel& m) { m.meshes[0].points[0][2] = endless; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.meshes[0].material = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.materials[0].picture = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.materials[0].colour[0] = endless; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[0].meshes[0] = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[1].parent = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[1].parent = -1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[1].light = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[1].camera = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.materials[0].normal_picture = 1; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.cameras[0].height = endless; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.nodes[1].transform[3] = endless; }) != "");
    CHECK(said_of([](ImportedModel& m) { m.lights[0].colour[0] = endless; }) != "");
}

}  // namespace candelabra
