// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/deep_stack.h"

#include <catch2/catch.hpp>

namespace {

std::size_t depth_of(std::size_t depth) {
    volatile char space[1000] = {};
    space[depth % 1000] = 1;
    return depth == 0 ? 0 : 1 + depth_of(depth - 1) + (space[0] & 0);
}

}  // namespace

TEST_CASE("a deep stack holds what the usual one does not", "[evaluate]") {
    std::size_t depth = 0, given = 0;
    on_deep_stack(std::size_t{256} << 20, [&](std::size_t bytes) {
        given = bytes;
        depth = depth_of(50'000);
    });
    CHECK(given == std::size_t{256} << 20);
    CHECK(depth == 50'000);
}
