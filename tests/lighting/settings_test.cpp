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

TEST_CASE("a strategy says what others need to know of it", "[lighting]") {
    CHECK_FALSE(traits(EveryLight{}).draws);
    CHECK(traits(LinearAlpha{}).draws);
    CHECK(traits(LightOctree{}).has_cells);
    CHECK_FALSE(traits(LightBvh{}).has_cells);
    CHECK(traits(LightOctree{}).wants_bent_normals);
    CHECK_FALSE(traits(LightBvh{}).by_transmittance);
    LightOctree paper;
    paper.paper = true;
    CHECK_FALSE(traits(paper).wants_bent_normals);
    LightBvh exponential;
    exponential.exponential = true;
    CHECK(traits(exponential).by_transmittance);
}

TEST_CASE("the fields of the light octree that have no effect follow from the others",
          "[lighting]") {
    const auto idle = [](const LightSampler& settings) {
        std::vector<std::string_view> names;
        for (const IdleField& field : idle_fields(settings)) names.push_back(field.name);
        return names;
    };
    const std::vector<std::string_view> of_paper = {"threshold", "white", "max_bright",
                                                    "representatives"},
                                        of_cuts = {"eta", "cut", "outlook", "alone"};
    LightOctree octree;
    CHECK(idle(octree) == of_paper);
    octree.alone = true;
    CHECK(idle(octree).back() == "outlook");
    octree.paper = true;
    CHECK(idle(octree) == of_cuts);
    CHECK(idle(LightBvh{}).empty());
}

}  // namespace candelabra
