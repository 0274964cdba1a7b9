// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/split.h"

#include "items.h"

#include <catch2/catch.hpp>

namespace {

constexpr double slack = 1e-12;
constexpr SplitCosts costs{1, 4, 0};

std::vector<Fragment> fragments_of(const std::vector<Item>& items) {
    std::vector<Fragment> fragments;
    for (const Item& item : items)
        fragments.push_back({item.box, static_cast<std::uint32_t>(fragments.size())});
    return fragments;
}

Box around(const std::vector<Fragment>& fragments) {
    Box box;
    for (const Fragment& f : fragments) box = join(box, f.box);
    return box;
}

/// The definition: cost of the halves, each with the chance that a ray through the cell meets it.
double cost_of(const std::vector<Fragment>& fragments, const Box& cell, int axis, double plane) {
    Box below = cell;
    Box above = cell;
    below.high[axis] = plane;
    above.low[axis] = plane;
    double n_below = 0;
    double n_above = 0;
    for (const Fragment& f : fragments) {
        n_below += reaches_below(f.box.low[axis], plane, slack);
        n_above += reaches_above(f.box.high[axis], plane, slack);
    }
    return costs.traversal +
           costs.intersection * (area(below) * n_below + area(above) * n_above) / area(cell);
}

std::vector<Item> row(int count) {
    std::vector<Item> items;
    for (int i = 0; i < count; ++i) items.push_back({{Vec3(i, 0, 0), Vec3(i + 0.5, 1, 1)}});
    return items;
}

}  // namespace

TEST_CASE("few fragments are divided where the heuristic is least", "[index]") {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const std::vector<Fragment> fragments =
            fragments_of(random_balls(2 + seed % 10, 0.02, 0.2, seed));
        const Box cell = around(fragments);
        const Split split = SplitFinder(costs, slack).find(fragments, cell);
        double least = costs.intersection * static_cast<double>(fragments.size());
        for (int axis = 0; axis < 3; ++axis) {
            for (int i = 1; i < 1000; ++i) {
                const double plane = cell.low[axis] + i * 0.001 * cell.size()[axis];
                least = std::min(least, cost_of(fragments, cell, axis, plane));
            }
        }
        CHECK(split.cost <= least + 1e-9);
        if (split.found())
            CHECK(split.cost == Approx(cost_of(fragments, cell, split.axis, split.position)));
    }
}

TEST_CASE("many fragments are divided nearly where the heuristic is least", "[index]") {
    const std::vector<Fragment> fragments = fragments_of(row(1000));
    const Split split = SplitFinder(costs, slack).find(fragments, around(fragments));
    REQUIRE(split.axis == 0);
    CHECK(split.position == Approx(500).margin(20));
    CHECK(split.cost < 4 * 1000 * 0.6);
}

TEST_CASE("empty space is cut off at both ends", "[index]") {
    for (const int count : {3, 100}) {
        const std::vector<Fragment> fragments = fragments_of(row(count));
        Box cell = around(fragments);
        cell.high.y = 100;
        const Split above = SplitFinder(costs, slack).find(fragments, cell);
        CHECK(above.axis == 1);
        CHECK(above.position == Approx(1));
        cell.high.y = 1;
        cell.low.y = -100;
        const Split below = SplitFinder(costs, slack).find(fragments, cell);
        CHECK(below.axis == 1);
        CHECK(below.position == Approx(0).margin(1e-9));
    }
}

TEST_CASE("cells that no plane improves stay whole", "[index]") {
    const Box unit_box{Vec3(0), Vec3(1)};
    for (const std::size_t count : {0, 1, 10, 1000}) {
        const std::vector<Fragment> fragments(count, Fragment{unit_box, 0});
        CHECK_FALSE(SplitFinder(costs, slack).find(fragments, unit_box).found());
    }
    const std::vector<Fragment> points(10, Fragment{{Vec3(0), Vec3(0)}, 0});
    CHECK_FALSE(SplitFinder(costs, 0).find(points, points[0].box).found());
}

TEST_CASE("a fragment without thickness comes to one side", "[index]") {
    std::vector<Fragment> fragments = fragments_of(row(6));
    fragments.push_back({{Vec3(3, -5, -5), Vec3(3, 5, 5)}, 6});
    const Split split = SplitFinder(costs, slack).find(fragments, around(fragments));
    REQUIRE(split.found());
    const Box& wall = fragments.back().box;
    CHECK((reaches_below(wall.low[split.axis], split.position, slack) &&
           reaches_above(wall.high[split.axis], split.position, slack)) == (split.axis != 0));
}
