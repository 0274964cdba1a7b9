// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/settings.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("light samplers are known by name", "[lighting]") {
    for (const char* name :
         {"every_light", "constant_alpha", "linear_alpha", "light_bvh", "light_octree"}) {
        CAPTURE(name);
        const std::size_t kind = Kinds<LightSampler>::find(name);
        REQUIRE(kind < Kinds<LightSampler>::count);
        CHECK(Kinds<LightSampler>::make(kind).index() == kind);
    }
    CHECK(Kinds<LightSampler>::find("light_tree") == Kinds<LightSampler>::count);
}

}  // namespace candelabra
