// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/huge_pages.h"

#include <catch2/catch.hpp>

#include <numeric>
#include <vector>

TEST_CASE("memory keeps its contents when it goes to huge pages", "[base]") {
    std::vector<int> numbers(5 << 20);
    std::iota(numbers.begin(), numbers.end(), 0);
    const std::vector<int> before = numbers;
    use_huge_pages(numbers.data() + 7, (numbers.size() - 7) * sizeof(int));
    use_huge_pages(numbers.data(), 100);
    use_huge_pages(nullptr, 0);
    CHECK(numbers == before);
}
