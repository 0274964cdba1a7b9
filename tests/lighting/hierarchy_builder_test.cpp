// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/hierarchy_builder.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Numbers on a line; a part costs its length.
struct LengthCost {
    struct Item {
        double at;
        LightIndex number;
        bool of_second_kind = false;
    };
    using Number = double;
    struct Sum {
        double low = INFINITY, high = -INFINITY;
    };
    static constexpr int bins = 8;
    static constexpr std::size_t many = 1000;

    static double place(const Item& item, int axis) { return axis == 0 ? item.at : 0; }
    static LightIndex light(const Item& item) { return item.number; }
    static int bin(double from_low, double size) {
        return static_cast<int>(from_low / size * bins);
    }
    static void add(Sum& sum, const Item& item) {
        sum = {std::min(sum.low, item.at), std::max(sum.high, item.at)};
    }
    static void add(Sum& sum, const Sum& part) {
        sum = {std::min(sum.low, part.low), std::max(sum.high, part.high)};
    }
    static double of(const Sum& sum) { return sum.high - sum.low; }
    static bool longer(double later, double earlier) { return later > earlier; }
    static double of_side(double, double) { return 1; }
    static bool is_second_kind(const Item& item) { return item.of_second_kind; }
};

std::vector<LengthCost::Item> items_at(const std::vector<double>& places) {
    std::vector<LengthCost::Item> result;
    for (const double place : places)
        result.push_back({place, static_cast<LightIndex>(result.size())});
    return result;
}

/// Checks that each node's halves are the next ones below it. Returns the depth.
int checked_depth_at(const std::vector<double>& places) {
    HierarchyBuilder<LengthCost> builder(items_at(places), {});
    std::vector<std::pair<std::size_t, std::size_t>> expected = {{0, places.size()}};
    std::vector<int> depths = {0};
    int deepest = 0;
    std::size_t nodes = 0;
    builder.build(1, [&](std::size_t node, std::size_t first, std::size_t middle, std::size_t end) {
        CHECK(node == nodes);
        REQUIRE(!expected.empty());
        CHECK(expected.back() == std::pair(first, end));
        const int depth = depths.back();
        expected.pop_back(), depths.pop_back();
        deepest = std::max(deepest, depth), ++nodes;
        if (middle == end) {
            CHECK(end - first == 1);
            return;
        }
        CHECK((first < middle && middle < end));
        expected.push_back({middle, end}), depths.push_back(depth + 1);
        expected.push_back({first, middle}), depths.push_back(depth + 1);
    });
    CHECK(nodes == 2 * places.size() - 1);
    std::vector<LightIndex> numbers;
    for (const LengthCost::Item& item : builder.items()) numbers.push_back(item.number);
    std::ranges::sort(numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) CHECK(numbers[i] == i);
    return deepest;
}

}  // namespace

TEST_CASE("a hierarchy has each item in one leaf, and its nodes depth first", "[lighting]") {
    Draw draw(1);
    std::vector<double> anywhere;
    for (int i = 0; i < 300; ++i) anywhere.push_back(draw.number());
    CHECK(checked_depth_at(anywhere) < 40);
    CHECK(checked_depth_at({3}) == 0);
    CHECK(checked_depth_at(std::vector<double>(64, 1.5)) == 6);  // halved by number
}

TEST_CASE("a hierarchy is cut where its parts cost least", "[lighting]") {
    HierarchyBuilder<LengthCost> builder(items_at({0, 9, 0.5, 10, 1}), {});
    std::vector<std::size_t> middles;
    builder.build(1, [&](std::size_t, std::size_t, std::size_t middle, std::size_t) {
        middles.push_back(middle);
    });
    CHECK(middles.front() == 3);
}

TEST_CASE("a hierarchy does not depend on the number of threads", "[lighting]") {
    Draw draw(2);
    std::vector<double> places;
    for (int i = 0; i < 30000; ++i) places.push_back(std::floor(draw.number() * 1000));
    const auto built = [&](int threads) {
        HierarchyBuilder<LengthCost> builder(items_at(places), {});
        std::vector<std::array<std::size_t, 3>> nodes(2 * places.size() - 1);
        builder.build(
            threads, [&](std::size_t node, std::size_t first, std::size_t middle, std::size_t end) {
                nodes[node] = {first, middle, end};
            });
        std::vector<LightIndex> order;
        for (const LengthCost::Item& item : builder.items()) order.push_back(item.number);
        return std::pair(nodes, order);
    };
    const auto one = built(1);
    CHECK(built(4) == one);
    CHECK(built(0) == one);
}

TEST_CASE("items in geometric progression do not make an endless hierarchy", "[lighting]") {
    std::vector<double> places;
    for (int i = 0; i < 1000; ++i) places.push_back(std::pow(0.5, i));
    CHECK(checked_depth_at(places) < 64 + 12);
}

}  // namespace candelabra
