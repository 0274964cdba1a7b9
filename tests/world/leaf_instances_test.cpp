// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/leaf_instances.h"

#include "support/draw.h"
#include "support/twins.h"

#include <catch2/catch.hpp>

#include <map>
#include <vector>

namespace candelabra {

namespace {

/// A floor that is no instance, and a crowd of unions, each of which overlaps many others.
Twins crowd() {
    return twins_of(R"(
        #declare R = seed(3);
        #declare Cluster = union {
            #for (I, 1, 12) sphere { <rand(R), rand(R), rand(R)> - 0.5, 0.06 } #end
            box { -0.05, 0.05 }
            pigment { rgb 0.8 }
        }
        #for (I, 1, 60)
            object { Cluster rotate 360*<rand(R), rand(R), 0>
                     translate 2*<rand(R), rand(R), rand(R)> - 1 }
        #end
        plane { y, -3 pigment { rgb 1 } }
    )");
}

}  // namespace

TEST_CASE("instances of a leaf are taken, and asked once each until one says yes", "[instances]") {
    const Twins twins = crowd();
    const Geometry& geometry = twins.shared->geometry;
    const std::uint32_t first = geometry.instances_begin();
    LeafInstances instances(geometry);
    CHECK_FALSE(instances.take(0));
    CHECK(instances.take(first + 5));
    CHECK(instances.take(first + 2));
    CHECK(instances.take(first + 9));
    std::vector<std::uint32_t> asked;
    const auto ask_until = [&](std::uint32_t last) {
        return instances.any_of([&](std::uint32_t item) {
            asked.push_back(item);
            return item == last;
        });
    };
    CHECK(ask_until(first + 2));
    CHECK(asked == std::vector{first + 5, first + 2});
    CHECK_FALSE(ask_until(first + 9));
    CHECK(asked.size() == 2);
}

TEST_CASE("unions that overlap stand in one leaf each, and rays meet them as if taken apart",
          "[instances]") {
    const Twins twins = crowd();
    const Geometry& geometry = twins.shared->geometry;
    REQUIRE(geometry.instances.size() == 60);
    std::map<std::uint32_t, int> leaves_with;
    geometry.tree.for_each_node([&](std::uint32_t number, const TreeFrame&, int) {
        const TreeNode& node = geometry.tree.nodes()[number];
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot)
            if (node.used(slot) && node.children[slot].is_leaf())
                for (const std::uint32_t item : geometry.tree.items(node.children[slot]))
                    ++leaves_with[item];
    });
    CHECK(leaves_with.size() == 60);
    for (const auto& [item, leaves] : leaves_with) CHECK(leaves == 1);
    Draw draw(2);
    Vec3 from, to;
    const auto next_ray = [&] {
        from = Vec3(draw.between(-2, 2), draw.between(-2, 2), -4);
        to = Vec3(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1));
        return Ray{from, unit(to - from)};
    };
    const auto same_shadow = [&](const Ray& ray, const Hit&, const Hit&) {
        CHECK(twins.shared->transmittance(ray, 1e-9, length(to - from)) ==
              twins.apart->transmittance(ray, 1e-9, length(to - from)));
    };
    CHECK(met_alike(twins, next_ray, same_shadow) > 1000);
}

}  // namespace candelabra
