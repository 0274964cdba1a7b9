// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/model_import.h"

#include "support/gltf.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("names beside a model stay in its folder", "[meshing]") {
    CHECK(name_beside("a.png") == "a.png");
    CHECK(name_beside("./wood/a.png") == "wood/a.png");
    CHECK(name_beside("wood\\a.png") == "wood/a.png");
    CHECK(name_beside("../../etc/passwd") == "passwd");
    CHECK(name_beside("wood/../../a.png") == "a.png");
    CHECK(name_beside("/etc/passwd") == "passwd");
    CHECK(name_beside("C:\\Users\\Ann\\a.png") == "a.png");
    CHECK(name_beside("C:a.png") == "a.png");
    CHECK(name_beside("file:///etc/passwd") == "passwd");
    CHECK(name_beside("..").empty());
    CHECK(name_beside("a/..").empty());
}

TEST_CASE("formats with parts are told by their extensions", "[meshing]") {
    for (const char* name : {"a.gltf", "a.GLB", "b/a.obj", "a.fbx", "a.dae", "a.3mf"})
        CHECK(has_parts(name));
    for (const char* name : {"a.ply", "a.stl", "a.off", "a.glb.png", "glb"})
        CHECK_FALSE(has_parts(name));
}

TEST_CASE("models are read in a process of their own, and ask for what lies beside them",
          "[meshing]") {
    std::vector<std::string> asked;
    const auto beside = [&](const std::string& name) -> std::optional<std::string> {
        asked.push_back(name);
        if (name == "triangle.bin") return triangle_bytes();
        return std::nullopt;
    };
    const auto read = [&](const std::string& text, Diagnostics& diagnostics) {
        return import_model({"models/a.gltf", text}, beside, diagnostics, {});
    };
    Diagnostics none, some;
    const auto model =
        read(gltf(R"({"buffers": [{"byteLength": 68, "uri": "triangle.bin"}]})"), none);
    REQUIRE(model);
    CHECK(model->meshes.at(0).vertices.size() == 3);
    CHECK(none.all().empty());
    CHECK(asked == std::vector<std::string>{"triangle.bin"});
    CHECK_FALSE(
        read(gltf(R"({"buffers": [{"byteLength": 68, "uri": "../../etc/passwd"}]})"), some));
    // It tries parts of the name as well, all of which are in the folder.
    CHECK(asked.at(1) == "passwd");
    for (const std::string& name : asked) CHECK(name_beside(name) == name);
    REQUIRE(some.all().size() == 1);
    CHECK(some.all()[0].message.starts_with("cannot read the model `models/a.gltf`: "));
}

}  // namespace candelabra
