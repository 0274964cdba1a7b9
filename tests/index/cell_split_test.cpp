// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/cell_split.h"

#include "items.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

constexpr TreeSettings single_costs{
    .by = Division::cells, .node_cost = 1, .group_cost = 4, .reference_cost = 0, .group = 1};

struct Cell {
    std::vector<PrimRef> fragments;
    Box box;

    explicit Cell(const std::vector<Item>& items) {
        for (const Item& item : items) {
            fragments.push_back({item.box, static_cast<std::uint32_t>(fragments.size())});
            box = join(box, item.box);
        }
    }
    CellSplit split(const TreeSettings& settings = single_costs) const {
        return find_cell_split(fragments, box, settings, 0);
    }
};

/// The definition: cost of a side times its area, to which the probability of meeting it is
/// proportional.
double side_cost(const CellSide& side) {
    return area(side.box) * cost_of_items(static_cast<double>(side.fragments.size()), single_costs);
}
double split_cost(const Cell& cell, const CellSplit& split) {
    const CellSides sides = divide(cell.fragments, split, {}, 0);
    return side_cost(sides.below) + side_cost(sides.above);
}

/// Minimum cost over all planes at the ends of boxes.
double min_split_cost(const Cell& cell) {
    double least = no_hit;
    for (int axis = 0; axis < 3; ++axis)
        for (const PrimRef& f : cell.fragments)
            for (const double plane : {f.box.low[axis], f.box.high[axis]})
                least = std::min(least, split_cost(cell, {axis, plane, 0}));
    return least;
}

}  // namespace

TEST_CASE("cells are divided nearly where the heuristic is least", "[index]") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Cell few(random_balls(4 + seed % 5, 0.02, 0.2, seed));
        REQUIRE(few.split().found());
        CHECK(split_cost(few, few.split()) < 1.01 * min_split_cost(few));
        const Cell some(random_balls(9 + seed % 30, 0.02, 0.2, seed));
        REQUIRE(some.split().found());
        CHECK(split_cost(some, some.split()) < 1.3 * min_split_cost(some));
        const Cell many(random_balls(60 + seed, 0.02, 0.2, seed));
        REQUIRE(many.split().found());
        CHECK(split_cost(many, many.split()) < 1.1 * min_split_cost(many));
    }
}

TEST_CASE("items that touch are on one side each", "[index]") {
    const Cell cell(touching_boxes(2));
    const CellSides sides = divide(cell.fragments, cell.split(), {}, 0);
    CHECK(sides.below.fragments.size() == 4);
    CHECK(sides.above.fragments.size() == 4);
}

TEST_CASE("what passes through a plane is in boxes around its parts on both sides", "[index]") {
    const std::vector<Item> items = {ball(Vec3(0), 1), ball(Vec3(3, 0, 0), 0.5)};
    const Cell cell(items);
    const auto part = [&](std::uint32_t item, const Box& side) {
        return part_of(items[item], side);
    };
    const CellSides sides = divide(cell.fragments, {0, 0.6, 0}, part, 0);
    REQUIRE(sides.below.fragments.size() == 1);
    REQUIRE(sides.above.fragments.size() == 2);
    CHECK(sides.below.box.high.x == 0.6);
    CHECK(sides.above.fragments[0].box.low.x == 0.6);
    CHECK(sides.above.fragments[0].box.high.y == Approx(0.8));
    CHECK(sides.above.box.high.x == 3.5);
}

TEST_CASE("what passes through neither side is left out", "[index]") {
    const Cell cell({ball(Vec3(0), 1)});
    const auto nowhere = [](std::uint32_t, const Box&) { return Box(); };
    const CellSides sides = divide(cell.fragments, {0, 0, 0}, nowhere, 0);
    CHECK(sides.below.fragments.empty());
    CHECK(sides.above.fragments.empty());
}

TEST_CASE("cells stay whole where planes cost more", "[index]") {
    std::vector<Item> row;
    for (int i = 0; i < 4; ++i) row.push_back({{Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1)}});
    CHECK(Cell(row).split().found());
    TreeSettings dear = single_costs;
    dear.node_cost = 1000;
    CHECK_FALSE(Cell(row).split(dear).found());
    // Long planks side by side would all be on both sides.
    std::vector<Item> planks;
    for (int i = 0; i < 40; ++i) planks.push_back({{Vec3(0, 0.001 * i, 0), Vec3(1, 0.001 * i, 1)}});
    dear = single_costs;
    dear.reference_cost = 1000;
    const CellSplit split = Cell(planks).split(dear);
    CHECK((!split.found() || split.axis == 1));
}

TEST_CASE("items in one place are not divided by planes", "[index]") {
    for (const std::size_t count : {1, 10, 1000})
        CHECK_FALSE(Cell(std::vector<Item>(count, ball(Vec3(0), 1))).split().found());
}

}  // namespace candelabra
