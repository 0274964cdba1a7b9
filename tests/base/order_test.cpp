// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/order.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <numeric>
#include <vector>

namespace candelabra {

namespace {

/// A number to order by, and one by which equal ones are told apart.
struct Marked {
    std::uint64_t key;
    int mark;

    bool operator<(const Marked& other) const { return key < other.key; }
};

std::vector<Marked> some(int count, std::uint64_t keys) {
    std::vector<Marked> made;
    for (int i = 0; i < count; ++i) made.push_back({mix(static_cast<std::uint64_t>(i)) % keys, i});
    return made;
}

std::uint64_t digest_of(const std::vector<Marked>& list) {
    std::uint64_t sum = 0;
    for (const Marked& m : list) sum = mix(sum ^ m.key << 32 ^ static_cast<std::uint64_t>(m.mark));
    return sum;
}

}  // namespace

TEST_CASE("equal elements keep their order when sorted", "[order]") {
    for (const int count : {0, 1, 2, 31, 32, 33, 1000}) {
        std::vector<Marked> list = some(count, 7);
        sort_stably(list, {}, &Marked::key);
        for (std::size_t i = 1; i < list.size(); ++i)
            CHECK(std::pair(list[i - 1].key, list[i - 1].mark) <
                  std::pair(list[i].key, list[i].mark));
    }
}

TEST_CASE("the nth element divides a list, whatever its order was", "[order]") {
    for (const int count : {1, 5, 9, 10, 100, 3000})
        for (const std::uint64_t keys :
             {std::uint64_t{1}, std::uint64_t{3}, std::uint64_t{1000000}})
            for (const bool sorted : {false, true}) {
                std::vector<Marked> list = some(count, keys), all = list;
                std::stable_sort(all.begin(), all.end());
                if (sorted) list = all;
                for (const int n : {0, count / 3, count / 2, count - 1}) {
                    put_nth(list.begin(), list.begin() + n, list.end());
                    CHECK(list[n].key == all[n].key);
                    CHECK_FALSE(std::any_of(list.begin(), list.begin() + n,
                                            [&](const Marked& m) { return list[n] < m; }));
                    CHECK_FALSE(std::any_of(list.begin() + n, list.end(),
                                            [&](const Marked& m) { return m < list[n]; }));
                }
            }
}

TEST_CASE("pivots that are always bad do not make the division slow", "[order]") {
    // Each comparison decides that the pivot is small, as an adversary would (McIlroy, 1999).
    std::vector<int> order(20000), value(20000, 1 << 30);
    std::iota(order.begin(), order.end(), 0);
    int solid = 0, candidate = 0;
    long compared = 0;
    put_nth(order.begin(), order.begin() + 10000, order.end(), [&](int a, int b) {
        ++compared;
        if (value[a] == 1 << 30 && value[b] == 1 << 30)
            (a == candidate ? value[a] : value[b]) = solid++;
        if (value[a] == 1 << 30) candidate = a;
        if (value[b] == 1 << 30) candidate = b;
        return value[a] < value[b];
    });
    CHECK(compared < 4 * 15 * 2 * 20000 + 20000 * 20);
}

TEST_CASE("elements that belong in front come there", "[order]") {
    for (const int count : {0, 1, 2, 100}) {
        std::vector<Marked> list = some(count, 100);
        const auto front = [](const Marked& m) { return m.key < 40; };
        const std::size_t before = put_in_front(list, front);
        CHECK(std::is_partitioned(list.begin(), list.end(), front));
        CHECK(before == static_cast<std::size_t>(std::count_if(list.begin(), list.end(), front)));
    }
}

TEST_CASE("a heap yields its elements in order", "[order]") {
    std::vector<Marked> heap;
    for (const Marked& m : some(500, 100000)) add_to_heap(heap, m);
    std::uint64_t last = heap.front().key;
    while (!heap.empty()) {
        CHECK(heap.front().key <= last);
        last = heap.front().key;
        remove_greatest(heap);
    }
}

TEST_CASE("orders are the same everywhere", "[order]") {
    // Whatever the standard library. A change of these numbers changes pictures.
    std::vector<Marked> list = some(1000, 50);
    put_nth(list.begin(), list.begin() + 300, list.end());
    CHECK(digest_of(list) == 0x8eab7cfd8a27aec7);
    put_in_front(list, [](const Marked& m) { return m.key % 3 == 0; });
    CHECK(digest_of(list) == 0x10ae1457e283025f);
    std::vector<Marked> heap;
    for (const Marked& m : list) add_to_heap(heap, m);
    for (int i = 0; i < 100; ++i) remove_greatest(heap);
    CHECK(digest_of(heap) == 0x6575bdfa388389bc);
}

}  // namespace candelabra
