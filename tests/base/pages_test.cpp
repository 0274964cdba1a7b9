// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/pages.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>

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

}  // namespace candelabra
