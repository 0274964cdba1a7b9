// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/memory_pages.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <numeric>
#include <vector>

namespace candelabra {

TEST_CASE("blocks of pages lie at multiples of their size and can be written", "[base]") {
    const bool all = GENERATE(false, true);
    void* const one = new_pages(all);
    void* const other = new_pages(all);
    CHECK(one != other);
    CHECK(reinterpret_cast<std::uintptr_t>(one) % page_block == 0);
    CHECK(static_cast<const char*>(one)[page_block - 1] == 0);
    std::memset(one, 7, page_block);
    CHECK(static_cast<const char*>(other)[0] == 0);
    free_pages(one);
    free_pages(other);
}

TEST_CASE("memory keeps its contents when it goes to huge pages", "[base]") {
    std::vector<int> numbers(5 << 20);
    std::iota(numbers.begin(), numbers.end(), 0);
    const std::vector<int> before = numbers;
    use_huge_pages(numbers.data() + 7, (numbers.size() - 7) * sizeof(int));
    use_huge_pages(numbers.data(), 100);
    use_huge_pages(nullptr, 0);
    CHECK(numbers == before);
}

TEST_CASE("huge pages are expected without a loss", "[base]") {
    std::vector<int> numbers;
    numbers.reserve(5 << 20);
    expect_huge_pages(numbers.data(), numbers.capacity() * sizeof(int));
    for (int i = 0; i < 5 << 20; ++i) numbers.push_back(i);
    CHECK(std::accumulate(numbers.begin(), numbers.end(), std::int64_t{0}) ==
          (std::int64_t{5} << 20) * ((5 << 20) - 1) / 2);
}

#ifdef __GLIBC__
TEST_CASE("what was freed between things in use goes back to the system", "[base]") {
    const auto resident = [] {
        std::ifstream file("/proc/self/statm");
        std::size_t all = 0, pages = 0;
        file >> all >> pages;
        return pages * 4096;
    };
    std::vector<std::vector<char>> blocks(1 << 15, std::vector<char>(2000, 'x'));
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (i % 512 != 0) std::vector<char>().swap(blocks[i]);
    const std::size_t before = resident();
    give_back_freed();
    CHECK(resident() + (std::size_t{1} << 25) < before);
    CHECK(blocks[512] == std::vector<char>(2000, 'x'));
}
#endif

}  // namespace candelabra
