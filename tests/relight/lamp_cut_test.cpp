// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_cut.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra {

namespace {

LampList one_group(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return LampList({{"Row", count}}, numbers, std::vector<float>(count, 1.0F));
}

std::vector<LampEntry> entries_of(std::initializer_list<float> sizes) {
    std::vector<LampEntry> entries;
    for (const float size : sizes)
        entries.push_back({static_cast<std::uint32_t>(entries.size()), 3, false, {size, 0, 0}});
    return entries;
}

}  // namespace

TEST_CASE("nodes with much light are divided first", "[relight]") {
    const LampList lamps = one_group(16);
    std::vector<LampAtom> atoms;
    for (std::uint32_t i = 0; i < 16; ++i) atoms.push_back({{i, i + 1}, i == 5 ? 100.0 : 1.0});
    CHECK(chosen_nodes(lamps, atoms, 1) == std::vector<LampRange>{{0, 16}});
    CHECK(chosen_nodes(lamps, atoms, 2) == std::vector<LampRange>{{0, 8}, {8, 16}});
    CHECK(chosen_nodes(lamps, atoms, 5) ==
          std::vector<LampRange>{{0, 4}, {4, 5}, {5, 6}, {6, 8}, {8, 16}});
    CHECK(chosen_nodes(lamps, atoms, 99).size() == 16);
    CHECK(chosen_nodes(lamps, {}, 4).empty());
}

TEST_CASE("a node without light is not chosen, and atoms are not divided", "[relight]") {
    const LampList lamps = one_group(16);
    const std::vector<LampAtom> atoms = {{{0, 4}, 50}, {{9, 10}, 1}};
    CHECK(chosen_nodes(lamps, atoms, 9) == std::vector<LampRange>{{0, 4}, {9, 10}});
}

TEST_CASE("thinning keeps large entries, and the expected sum of the others", "[relight]") {
    auto kept = entries_of({9, 1, 1, 1, 1, 8, 1, 1, 1, 1});
    const auto all = kept;
    thin(kept, 10, 0.5);
    CHECK(kept == all);
    std::vector<double> sums(10);
    constexpr int trials = 4000;
    for (int i = 0; i < trials; ++i) {
        auto some = all;
        thin(some, 4, (i + 0.5) / trials);
        REQUIRE(some.size() == 4);
        CHECK(some.front() == all.front());
        for (const LampEntry& entry : some) sums[entry.lamp] += entry.light[0] / trials;
    }
    for (std::size_t i = 0; i < 10; ++i) CHECK(sums[i] == Approx(all[i].light[0]).epsilon(0.01));
    thin(kept, 0, 0.5);
    CHECK(kept.empty());
}

TEST_CASE("entries without light are the first to go", "[relight]") {
    auto entries = entries_of({0, 0, 1, 0});
    thin(entries, 2, 0.9);
    REQUIRE_FALSE(entries.empty());
    bool there = false;
    for (const LampEntry& entry : entries) there |= entry.light[0] == 1;
    CHECK(there);
}

TEST_CASE("entries of one lamp in one pixel are summed", "[relight]") {
    const std::vector<LampEntry> made = summed({{7, 2, false, {1, 0, 0}},
                                                {3, 2, false, {0, 1, 0}},
                                                {7, 1, false, {1, 1, 1}},
                                                {7, 2, false, {2, 0, 5}},
                                                {7, 2, true, {4, 4, 4}}});
    CHECK(made == std::vector<LampEntry>{{7, 1, false, {1, 1, 1}},
                                         {3, 2, false, {0, 1, 0}},
                                         {7, 2, false, {3, 0, 5}},
                                         {7, 2, true, {4, 4, 4}}});
}

}  // namespace candelabra
