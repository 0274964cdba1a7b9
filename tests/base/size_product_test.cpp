// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/size_product.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>

namespace candelabra {

TEST_CASE("products of sizes do not wrap around, in 32 bits either", "[base]") {
    constexpr auto most = std::numeric_limits<std::uint32_t>::max();
    struct Row {
        std::uint32_t a, b, c, product;
    };
    const Row rows[] = {{3, 4, 5, 60},
                        {0, most, most, 0},
                        {1, 1, most, most},
                        {65535, 65535, 1, 4294836225U},
                        {65536, 65536, 1, most},   // 2^32: would be 0
                        {65535, 65535, 64, most},  // the sums of the largest picture
                        {85899346, 50, 1, most},   // would be 4
                        {2048, 2097152, 1, most},  // would be 0
                        {65536, 65536, 0, most}};  // as soon as it has no room
    for (const Row& row : rows) {
        CAPTURE(row.a, row.b, row.c);
        CHECK(size_product(row.a, row.b, row.c) == row.product);
    }
    CHECK(size_product(std::uint64_t{1} << 32, std::uint64_t{1} << 31) == std::uint64_t{1} << 63);
    CHECK(size_product(std::uint64_t{1} << 32, std::uint64_t{1} << 32) ==
          std::numeric_limits<std::uint64_t>::max());
}

}  // namespace candelabra
