// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/imported.h"
#include "support/gltf.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("broken models are errors", "[imports]") {
    const std::string whole = glb();
    CHECK(imported("a.glb", whole).problem.empty());
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{3}, std::size_t{19}, std::size_t{200}})
        CHECK_FALSE(imported("a.glb", whole.substr(0, size)).problem.empty());
    for (const char* name : {"a.gltf", "a.obj", "a.fbx", "a.dae", "a.3mf"}) {
        INFO(name);
        CHECK_FALSE(imported(name, "").problem.empty());
        CHECK_FALSE(imported(name, "nonsense").problem.empty());
    }
}

}  // namespace candelabra
