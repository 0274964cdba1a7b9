// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/node_builder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

namespace candelabra {

namespace {

struct Row {
    Vec3 centre;
    double half;
    std::uint32_t count;  ///< number of items in the same place
};

/// Items are numbered in order.
BuiltNodes nodes_of(const std::vector<Row>& rows, const NodeTask& task = {}) {
    std::vector<PrimRef> fragments;
    Box around;
    for (const Row& row : rows)
        for (std::uint32_t i = 0; i < row.count; ++i) {
            const Box box{row.centre - Vec3(row.half), row.centre + Vec3(row.half)};
            fragments.push_back({box, static_cast<std::uint32_t>(fragments.size())});
            around = join(around, box);
        }
    return build_nodes(task, fragments, around);
}

std::size_t used(const TreeNode& node) {
    std::size_t count = 0;
    while (count < TreeNode::width && node.used(count)) ++count;
    return count;
}

std::span<const std::uint32_t> items_of(const BuiltNodes& built, TreeChild leaf) {
    const std::size_t place = leaf.leaf();
    return std::span(built.leaves).subspan(place + 1, built.leaves[place]);
}

/// Items of all leaves.
std::vector<std::uint32_t> items_of(const BuiltNodes& built) {
    std::vector<std::uint32_t> items;
    for (const TreeNode& node : built.nodes)
        for (std::size_t slot = 0; slot < used(node); ++slot) {
            if (!node.children[slot].is_leaf()) continue;
            const auto leaf = items_of(built, node.children[slot]);
            items.insert(items.end(), leaf.begin(), leaf.end());
        }
    return items;
}

}  // namespace

TEST_CASE("a single item is a leaf below the only node", "[index]") {
    const BuiltNodes built = nodes_of({{Vec3(1, 2, 3), 0.5, 1}});
    REQUIRE(built.nodes.size() == 1);
    CHECK(used(built.nodes[0]) == 1);
    CHECK(built.nodes[0].children[0] == TreeChild::leaf(1));
    CHECK(items_of(built) == std::vector<std::uint32_t>{0});
    CHECK(built.frames.size() == 1);
    CHECK(built.prospect.chance == Approx(0.5));
    CHECK(built.prospect.steps == 4);
}

TEST_CASE("the child that is likelier to stop rays has the higher slot", "[index]") {
    const Vec3 left(0), right(10, 0, 0);
    for (const bool swapped : {false, true}) {
        const BuiltNodes built =
            nodes_of({{swapped ? right : left, 1, 1}, {swapped ? left : right, 1, 8}});
        REQUIRE(built.nodes.size() == 1);
        REQUIRE(used(built.nodes[0]) == 2);
        CHECK(items_of(built, built.nodes[0].children[0]).size() == 1);
        CHECK(items_of(built, built.nodes[0].children[1]).size() == 8);
    }
}

TEST_CASE("what is tiny beside all begins a frame", "[index]") {
    std::vector<Row> rows = {{Vec3(100, 0, 0), 1, 1}};
    for (int i = 0; i < 400; ++i) rows.push_back({Vec3(1e-6 * i, 0, 0), 1e-7, 1});
    const BuiltNodes built = nodes_of(rows);
    REQUIRE(built.frames.size() > 1);
    CHECK(built.frames[0].root == 0);
    CHECK(built.frames[1].reach < 50 * 0x1p-10);
    CHECK(built.nodes[built.frames[1].root].used(0));
    std::vector<std::uint32_t> items = items_of(built), all(401);
    std::ranges::sort(items);
    std::iota(all.begin(), all.end(), 0u);
    CHECK(items == all);
}

TEST_CASE("children of parts that are built apart lead to the same items", "[index]") {
    std::vector<Row> rows;
    for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 30; ++j)
            for (int k = 0; k < 30; ++k) rows.push_back({Vec3(i, j, k), 0.3, 1});
    const BuiltNodes built = nodes_of(rows);
    std::size_t leaves = 0;
    for (const TreeNode& node : built.nodes)
        for (std::size_t slot = 0; slot < used(node); ++slot) {
            const TreeChild child = node.children[slot];
            if (!child.is_leaf()) {
                REQUIRE(child.is_node());
                CHECK(child.node() < built.nodes.size());
                continue;
            }
            ++leaves;
            Box box = node.box(slot, built.frames[0].origin);
            box = {box.low - Vec3(1e-4), box.high + Vec3(1e-4)};
            for (const std::uint32_t item : items_of(built, child))
                CHECK(contains(box, rows[item].centre));
        }
    CHECK(leaves >= rows.size() / 8);
    CHECK(items_of(built).size() == rows.size());
}

}  // namespace candelabra
