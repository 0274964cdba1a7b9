// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/split.h"

#include "items.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

constexpr TreeSettings costs{.node_cost = 1, .group_cost = 4, .group = 1};

std::vector<PrimRef> fragments_of(const std::vector<Item>& items) {
    std::vector<PrimRef> fragments;
    for (const Item& item : items)
        fragments.push_back({item.box, static_cast<std::uint32_t>(fragments.size())});
    return fragments;
}

Box around(std::span<const PrimRef> fragments) {
    Box box;
    for (const PrimRef& f : fragments) box = join(box, f.box);
    return box;
}

/// The definition: cost of both sides, each times the probability that a ray through the whole
/// meets it.
double cost_of(std::span<const PrimRef> below, std::span<const PrimRef> above) {
    const auto side = [](std::span<const PrimRef> part) {
        return area(around(part)) * cost_of_items(static_cast<double>(part.size()), costs);
    };
    return side(below) + side(above);
}

double cost_of(const std::vector<PrimRef>& fragments, const Split& split) {
    std::vector<PrimRef> sides = fragments;
    const auto above = std::partition(sides.begin(), sides.end(),
                                      [&](const PrimRef& f) { return split.puts_below(f.box); });
    const auto below = static_cast<std::size_t>(above - sides.begin());
    return cost_of(std::span(sides).first(below), std::span(sides).subspan(below));
}

/// Minimum cost of all divisions along an axis.
double min_cost(std::vector<PrimRef> fragments) {
    double least = no_hit;
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::sort(fragments, {}, [&](const PrimRef& f) { return f.box.centre()[axis]; });
        for (std::size_t n = 1; n < fragments.size(); ++n)
            least = std::min(
                least, cost_of(std::span(fragments).first(n), std::span(fragments).subspan(n)));
    }
    return least;
}

std::vector<Item> row(int count) {
    std::vector<Item> items;
    for (int i = 0; i < count; ++i) items.push_back({{Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1)}});
    return items;
}

}  // namespace

TEST_CASE("items are divided nearly where the heuristic is least", "[index]") {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const std::vector<PrimRef> fragments =
            fragments_of(random_balls(4 + seed % 60, 0.02, 0.2, seed));
        const Split split = find_split(fragments, around(fragments), costs, true);
        REQUIRE(split.found());
        CHECK(cost_of(fragments, split) < 1.3 * min_cost(fragments));
    }
    const std::vector<PrimRef> many = fragments_of(row(1000));
    const Split split = find_split(many, around(many), costs, false);
    CHECK(split.axis == 0);
    CHECK(cost_of(many, split) < 1.05 * min_cost(many));
}

TEST_CASE("the boxes of a split's sides hold what it puts there, and no more", "[index]") {
    for (const ItemScene& scene : scenes()) {
        CAPTURE(scene.name);
        const std::vector<PrimRef> fragments = fragments_of(scene.items);
        const Split split = find_split(fragments, around(fragments), costs, true);
        if (!split.found()) continue;
        Box below, above;
        for (const PrimRef& f : fragments) {
            Box& side = split.puts_below(f.box) ? below : above;
            side = join(side, f.box);
        }
        CHECK(below.low == split.below.low);
        CHECK(below.high == split.below.high);
        CHECK(above.low == split.above.low);
        CHECK(above.high == split.above.high);
    }
}

TEST_CASE("items stay together where dividing them costs more", "[index]") {
    const std::vector<PrimRef> fragments = fragments_of(row(4));
    constexpr TreeSettings dear{.node_cost = 1000, .group_cost = 1, .group = 1};
    CHECK_FALSE(find_split(fragments, around(fragments), dear, false).found());
    CHECK(find_split(fragments, around(fragments), dear, true).found());
}

TEST_CASE("items in one place are not divided", "[index]") {
    const Box unit_box{Vec3(0), Vec3(1)};
    for (const std::size_t count : {1, 10, 1000}) {
        const std::vector<PrimRef> fragments(count, PrimRef{unit_box, 0});
        for (const bool forced : {false, true})
            CHECK_FALSE(find_split(fragments, unit_box, costs, forced).found());
    }
}

TEST_CASE("the last items of a group cost half of what a full one does, and their share",
          "[index]") {
    constexpr TreeSettings eight{.group_cost = 2, .group = 8};
    CHECK(cost_of_items(0, eight) == 0);
    CHECK(cost_of_items(8, eight) == 2);
    CHECK(cost_of_items(1, eight) == Approx(2 * 0.5 * (1 / 8.0 + 1)));
    CHECK(cost_of_items(12, eight) == Approx(2 * 0.5 * (1.5 + 2)));
}

}  // namespace candelabra
