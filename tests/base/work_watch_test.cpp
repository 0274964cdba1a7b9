// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/work_watch.h"

#include <catch2/catch.hpp>

#include <thread>

namespace candelabra {

namespace {

/// Counts until the work ends; at most that many steps.
std::uint32_t steps_until_end(std::uint32_t most) {
    std::uint32_t steps = 0;
    try {
        for (; steps < most; ++steps) count_work(1);
    } catch (const WorkEnded&) {
    }
    return steps;
}

}  // namespace

TEST_CASE("work that is watched ends after some ten thousand steps", "[base]") {
    bool ended = false;
    const std::function<bool()> asked = [&] { return ended; };
    const WorkWatch watch(asked);
    CHECK(steps_until_end(1'000'000) == 1'000'000);
    ended = true;
    CHECK(steps_until_end(1'000'000) < 50'000);
    CHECK(steps_until_end(1'000'000) < 50'000);
}

TEST_CASE("a watch tells how many steps were counted", "[base]") {
    const std::function<bool()> never = [] { return false; };
    const WorkWatch watch(never);
    CHECK(watch.counted() == 0);
    for (int i = 0; i < 123'456; ++i) count_work(7);
    CHECK(watch.counted() == 7 * 123'456);
    count_work(2'000'000'000);
    CHECK(watch.counted() == 7 * 123'456 + 2'000'000'000);
}

TEST_CASE("work without a watch, or with an empty one, goes on", "[base]") {
    const std::function<bool()> always = [] { return true; }, nobody;
    CHECK(steps_until_end(200'000) == 200'000);
    {
        const WorkWatch watch(always);
        CHECK(steps_until_end(200'000) < 50'000);
        const WorkWatch inner(nobody);
        CHECK(steps_until_end(200'000) == 200'000);
        std::thread([] { CHECK(steps_until_end(200'000) == 200'000); }).join();
    }
    CHECK(steps_until_end(200'000) == 200'000);
}

}  // namespace candelabra
