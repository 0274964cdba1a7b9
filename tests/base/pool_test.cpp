// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pool.h"

#include <catch2/catch.hpp>

#include <set>
#include <vector>

namespace candelabra {

namespace {

/// Counts its live instances.
struct CountedItem {
    explicit CountedItem(int& count) : count(count) { ++count; }
    ~CountedItem() { --count; }
    int& count;
    double more[7] = {};
};

}  // namespace

TEST_CASE("values of a pool live as long as their handles, in whatever order these go", "[base]") {
    const std::size_t step = GENERATE(1u, 7u, 4999u);
    int count = 0;
    constexpr std::size_t many = 10000;
    std::vector<Handle<CountedItem>> held;
    {
        Pool<CountedItem> pool;
        for (std::size_t i = 0; i < many; ++i) held.push_back(pool.make(count));
        CHECK(count == static_cast<int>(many));
        for (std::size_t i = 0; i < many; i += 2) held[i] = nullptr;
        CHECK(count == static_cast<int>(many / 2));
        held[0] = pool.make(count);
    }
    CHECK(count == static_cast<int>(many / 2) + 1);
    for (std::size_t i = 0; i < many; ++i) held[i * step % many] = nullptr;
    for (Handle<CountedItem>& handle : held) handle = nullptr;
    CHECK(count == 0);
}

TEST_CASE("values that are made in passing use one block again and again", "[base]") {
    int count = 0;
    Pool<CountedItem> pool;
    std::set<const CountedItem*> places;
    for (int i = 0; i < 200000; ++i) places.insert(pool.make(count).get());
    CHECK(count == 0);
    CHECK(places.size() * sizeof(CountedItem) < page_block);
    // A value that stays is left alone by those after it.
    const Handle<CountedItem> kept = pool.make(count);
    for (int i = 0; i < 200000; ++i) CHECK(pool.make(count).get() != kept.get());
    CHECK(count == 1);
}

TEST_CASE("a pool that has made nothing holds nothing", "[base]") {
    const Pool<CountedItem> pool;
    Pool<std::vector<int>> vectors;
    CHECK(vectors.make(3, 7)->size() == 3);
    const Handle<std::vector<int>> one = vectors.make(2, 5), other = vectors.make(1, 4);
    CHECK(*one == std::vector{5, 5});
    CHECK(*other == std::vector{4});
}

}  // namespace candelabra
