// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/deep_stack.h"

#include <catch2/catch.hpp>

#include <new>

namespace candelabra {

namespace {

std::size_t depth_of(std::size_t depth) {
    volatile char space[1000] = {};
    space[depth % 1000] = 1;
    return depth == 0 ? 0 : 1 + depth_of(depth - 1) + (space[0] & 0);
}

}  // namespace

TEST_CASE("a deep stack holds what the usual one does not", "[base]") {
    std::size_t depth = 0, given = 0;
    on_deep_stack(std::size_t{256} << 20, [&](std::size_t bytes) {
        given = bytes;
        depth = depth_of(50'000);
    });
    CHECK(given == std::size_t{256} << 20);
    CHECK(depth == 50'000);
}

TEST_CASE("a deep stack serves what asks for one again", "[base]") {
    constexpr std::size_t bytes = std::size_t{64} << 20;
    std::size_t inner = 0;
    const void* outer_thread = nullptr;
    const void* inner_thread = &inner;
    thread_local char mark = 0;
    on_deep_stack(bytes, [&](std::size_t) {
        outer_thread = &mark;
        on_deep_stack(bytes, [&](std::size_t left) {
            inner_thread = &mark;
            inner = left;
        });
    });
    CHECK(outer_thread == inner_thread);
    CHECK(inner < bytes);
    CHECK(inner > bytes / 2);
}

TEST_CASE("what is thrown on a deep stack comes out of it", "[base]") {
    const auto fails = [](std::size_t) { throw std::bad_alloc(); };
    CHECK_THROWS_AS(on_deep_stack(std::size_t{64} << 20, fails), std::bad_alloc);
}

}  // namespace candelabra
