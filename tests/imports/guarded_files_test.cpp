// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string obj_of_two = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Red\nf 1 2 3\n";

}  // namespace

TEST_CASE("models see what lies beside them through the program only", "[imports]") {
    const Imported with =
        imported("a.obj", obj_of_two, {{"a.mtl", "newmtl Red\nKd 1 0 0\nKe 0 0 2\nd 0.5\n"}});
    REQUIRE(with.problem.empty());
    CHECK(with.asked == std::vector<std::string>{"a.mtl"});
    const ImportedMaterial& red =
        with.model.materials.at(static_cast<std::size_t>(with.model.meshes.at(0).material));
    CHECK(red.name == "Red");
    CHECK(red.colour == std::array<double, 3>{1, 0, 0});
    CHECK(red.emission == std::array<double, 3>{0, 0, 2});
    CHECK(red.opacity == 0.5);
    const Imported without = imported("a.obj", obj_of_two);
    CHECK(without.problem.empty());
    REQUIRE(without.model.meshes.at(0).material >= 0);
    for (const ImportedMaterial& material : without.model.materials) CHECK_FALSE(material.stated);
    CHECK(red.stated);
    const Imported buffer = imported("a.gltf", gltf(R"({"buffers": [
        {"byteLength": 68, "uri": "../../etc/passwd"}]})"));
    CHECK_FALSE(buffer.problem.empty());
    CHECK(buffer.asked.front() == "../../etc/passwd");
}

}  // namespace candelabra
