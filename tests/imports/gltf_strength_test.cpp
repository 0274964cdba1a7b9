// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

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

}  // namespace candelabra
