// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/spatial_splits.h"

#include "items.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

/// A line segment without thickness.
struct Stick {
    Vec3 from, to;

    Vec3 at(double share) const { return from + share * (to - from); }
    Box box() const { return {glm::min(from, to), glm::max(from, to)}; }
};

Box part_of(const Stick& stick, const Box& cell) {
    Interval within{0, 1};
    for (int axis = 0; axis < 3; ++axis) {
        const double way = stick.to[axis] - stick.from[axis];
        double enter = (cell.low[axis] - stick.from[axis]) / way;
        double leave = (cell.high[axis] - stick.from[axis]) / way;
        if (enter > leave) std::swap(enter, leave);
        within = {std::max(within.min, enter), std::min(within.max, leave)};
    }
    if (within.min > within.max) return {};
    return clip(Stick{stick.at(within.min), stick.at(within.max)}.box(), cell);
}

std::vector<Stick> sticks(std::size_t count, double length, std::uint64_t seed) {
    Random random(seed);
    std::vector<Stick> made;
    while (made.size() < count) {
        const Vec3 from = point_in(random, {Vec3(-1), Vec3(1)});
        made.push_back({from, from + length * direction(random)});
    }
    return made;
}

struct Cuts {
    std::vector<PrimRef> whole, pieces;
    Box around;

    explicit Cuts(const std::vector<Stick>& sticks) {
        for (std::uint32_t i = 0; i < sticks.size(); ++i) {
            whole.push_back({sticks[i].box(), i});
            around = join(around, sticks[i].box());
        }
        const auto part = [&](std::uint32_t i, const Box& cell) {
            return part_of(sticks[i], cell);
        };
        pieces = pieces_of(whole, around, part, 1e-12);
    }
};

double area_of(std::span<const PrimRef> fragments) {
    double sum = 0;
    for (const PrimRef& f : fragments) sum += area(f.box);
    return sum;
}

WideTree tree_of(const std::vector<Stick>& sticks, int threads = 0) {
    return build_tree(
        static_cast<std::uint32_t>(sticks.size()), [&](std::uint32_t i) { return sticks[i].box(); },
        [&](std::uint32_t i, const Box& cell) { return part_of(sticks[i], cell); }, {}, threads);
}

}  // namespace

TEST_CASE("pieces of long items aslant have small boxes, which hold all of the items", "[index]") {
    const std::vector<Stick> all = sticks(4000, 2, 1);
    const Cuts cut(all);
    CHECK(cut.pieces.size() > 8000);
    CHECK(cut.pieces.size() <= 16000);
    CHECK(area_of(cut.pieces) < 0.4 * area_of(cut.whole));
    Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const auto item = static_cast<std::uint32_t>(i % 4000);
        const Vec3 point = all[item].at(uniform(random, 0, 1));
        CHECK(std::ranges::any_of(cut.pieces, [&](const PrimRef& f) {
            const Box near{f.box.low - Vec3(1e-12), f.box.high + Vec3(1e-12)};
            return f.item == item && contains(near, point);
        }));
    }
}

TEST_CASE("of items among shorter ones only the long ones are cut", "[index]") {
    std::vector<Stick> all = sticks(2000, 0.01, 3);
    const std::vector<Stick> longer = sticks(600, 3, 4);
    all.insert(all.end(), longer.begin(), longer.end());
    const Cuts cut(all);
    CHECK(area_of(cut.pieces) < 0.6 * area_of(cut.whole));
    const auto of_short =
        std::ranges::count_if(cut.pieces, [](const PrimRef& f) { return f.item < 2000; });
    CHECK(of_short == 2000);
    CHECK(cut.pieces.size() > 2000 + 900);
}

TEST_CASE("items stay whole where rays meet few of them, or where they fill their boxes",
          "[index]") {
    CHECK(Cuts(sticks(1000, 0.05, 5)).pieces.empty());
    CHECK(Cuts({}).pieces.empty());
    std::vector<PrimRef> balls;
    Box around;
    for (const Item& item : random_balls(1000, 0.4, 0.5, 6)) {
        balls.push_back({item.box, 0});
        around = join(around, item.box);
    }
    REQUIRE(area_of(balls) > 50 * area(around));
    const auto all_of_it = [](std::uint32_t, const Box& cell) { return cell; };
    CHECK(pieces_of(balls, around, all_of_it, 0).empty());
}

TEST_CASE("rays find items that the hierarchy has in pieces", "[index]") {
    const std::vector<Stick> all = sticks(20000, 1, 7);
    const WideTree tree = tree_of(all);
    std::vector<std::uint32_t> held;
    tree.for_each_node([&](std::uint32_t number, const TreeFrame&, int) {
        const TreeNode& node = tree.nodes()[number];
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot) {
            if (!node.used(slot) || !node.children[slot].is_leaf()) continue;
            const auto items = tree.items(node.children[slot]);
            CHECK(std::ranges::adjacent_find(items, std::greater_equal()) == items.end());
            held.insert(held.end(), items.begin(), items.end());
        }
    });
    CHECK(held.size() > 2 * all.size());
    Random random(8);
    for (int i = 0; i < 20000; ++i) {
        const auto item = static_cast<std::uint32_t>(i);
        const Vec3 origin = point_in(random, {Vec3(-3), Vec3(3)});
        const Vec3 way = all[item].at(uniform(random, 0, 1)) - origin;
        const Ray ray{origin, unit(way)};
        const Interval range{0, length(way)};
        const auto find = [&](std::span<const std::uint32_t> items, Interval&) {
            return std::ranges::find(items, item) != items.end();
        };
        CHECK(tree.traverse(ray, range, find));
        CHECK(tree.traverse_likely(ray, range, find));
    }
}

TEST_CASE("pieces are the same for any number of threads", "[index]") {
    const std::vector<Stick> all = sticks(40000, 1, 9);
    const WideTree one = tree_of(all, 1), four = tree_of(all, 4);
    CHECK(std::ranges::equal(one.nodes(), four.nodes()));
    CHECK(std::ranges::equal(one.frames(), four.frames()));
}

}  // namespace candelabra
