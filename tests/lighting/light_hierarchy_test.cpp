// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_hierarchy.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the depth of the tree, after checking that each luminaire is in one leaf and each node's
/// sphere contains everything below it.
int checked_depth(const std::vector<Luminaire>& luminaires) {
    const std::vector<LightNode> nodes = build_light_hierarchy(*choices(luminaires));
    REQUIRE(nodes.size() == 2 * luminaires.size() - 1);
    std::vector<int> seen(luminaires.size()), depth(nodes.size());
    int deepest = 0;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        depth[i] = i == 0 ? 0 : depth[nodes[i].parent] + 1;
        deepest = std::max(deepest, depth[i]);
        if (!nodes[i].leaf) {
            CHECK(nodes[i + 1].parent == i);
            CHECK(nodes[nodes[i].second].parent == i);
            CHECK(nodes[i].intensity ==
                  Approx(nodes[i + 1].intensity + nodes[nodes[i].second].intensity));
            continue;
        }
        ++seen[nodes[i].second];
        const LightBounds b = bounds(luminaires[nodes[i].second]);
        for (std::uint32_t above = i; above != 0; above = nodes[above].parent) {
            const LightNode& parent = nodes[nodes[above].parent];
            for (int axis = 0; axis < 3; ++axis)
                CHECK(std::abs(parent.centre[axis] - b.box.low[axis]) <=
                      parent.radius * (1 + 1e-9));
            if (parent.axis == decltype(parent.axis)(0)) continue;
            // Normals are within the cone, whichever way they point.
            REQUIRE(b.axis != Vec3(0));
            CHECK(std::abs(dot(Vec3(parent.axis), b.axis)) >= parent.cos_spread - 1e-5);
        }
    }
    for (const int count : seen) CHECK(count == 1);
    return deepest;
}

}  // namespace

TEST_CASE("a light hierarchy holds every luminaire once, in spheres and cones that are wide enough",
          "[lighting]") {
    Draw draw(1);
    for (const int count : {1, 2, 3, 10, 200})
        for (const int kinds : {1, 2, emitter_kinds}) {
            std::vector<Luminaire> luminaires;
            for (int i = 0; i < count; ++i)
                luminaires.push_back(
                    glowing(emitter(i % kinds, draw.point(5), draw.between(0.01, 0.3), draw)));
            CHECK(checked_depth(luminaires) < 40);
        }
}

TEST_CASE("triangles that lie in one plane keep a narrow cone", "[lighting]") {
    Draw draw(2);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 50; ++i) {
        const Vec3 at(draw.point(5).x, draw.point(5).y, 0);
        // Half of them are reversed: they shine on both sides all the same.
        const Vec3 side = i % 2 ? Vec3(1, 0, 0) : Vec3(0, 1, 0),
                   other = i % 2 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        luminaires.push_back(glowing(TriangleEmitter{at, at + 0.1 * side, at + 0.1 * other}));
    }
    const std::vector<LightNode> nodes = build_light_hierarchy(*choices(luminaires));
    CHECK(nodes[0].cos_spread == Approx(1));
    CHECK(std::abs(nodes[0].axis.z) == Approx(1));
}

TEST_CASE("the cone of lamps at right angles does not follow the rounding of their product",
          "[lighting]") {
    const auto axis_of_both = [](double lean) {
        const auto lamp = [](const Vec3& at, const Vec3& one, const Vec3& other) {
            return glowing(TriangleEmitter{at, at + one, at + other});
        };
        return Vec3(build_light_hierarchy(*choices(
            std::vector<Luminaire>{lamp(Vec3(0), Vec3(0, 0, 1), Vec3(1, 0, 0)),
                                   lamp(Vec3(3, 0, 0), Vec3(0, 0, 1), Vec3(-lean, 1, 0))}))[0]
                        .axis);
    };
    CHECK(length(axis_of_both(1e-15) - axis_of_both(-1e-15)) < 0.1);
}

TEST_CASE("luminaires in geometric progression, or all in one place, make no endless tree",
          "[lighting]") {
    std::vector<Luminaire> progression, together;
    for (int i = 0; i < 400; ++i)
        progression.push_back(
            glowing(SphereEmitter{Vec3(std::pow(0.5, i), 0, 0), std::pow(0.5, i) / 8}));
    for (int i = 0; i < 300; ++i) together.push_back(glowing(SphereEmitter{Vec3(1, 2, 3), 0.5}));
    const int deep = checked_depth(progression);
    CHECK(deep > 64);
    CHECK(deep < 64 + 12);
    CHECK(checked_depth(together) < 12);
    CHECK(build_light_hierarchy(*choices({})).empty());
}

}  // namespace candelabra
