// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.h"

#include "base/unless_ended.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <functional>
#include <vector>

namespace candelabra {

TEST_CASE("each job runs once, for any number of threads", "[base]") {
    for (const int threads : {0, 1, 2, 7})
        for (const std::size_t count : {0u, 1u, 1000u}) {
            std::vector<int> runs(count);
            run_parallel(count, threads, [&](std::size_t i) { ++runs[i]; });
            CHECK(runs == std::vector<int>(count, 1));
        }
    CHECK(core_count() >= 1);
}

TEST_CASE("both are run once, also from within each other", "[base]") {
    for (const int threads : {0, 1, 2}) {
        std::vector<int> runs(4);
        const auto pair = [&](std::size_t first) {
            run_both(
                threads, [&runs, first] { ++runs[first]; }, [&runs, first] { ++runs[first + 1]; });
        };
        run_on_threads(threads, [&] {
            run_both(
                threads, [&] { pair(0); }, [&] { pair(2); });
        });
        CHECK(runs == std::vector<int>(4, 1));
    }
}

TEST_CASE("threads that help work which is watched everywhere end with it", "[base]") {
    for (const int threads : {1, 4}) {
        std::atomic<int> begun = 0;
        const std::function<bool()> ended = [&] { return begun >= std::min(threads, 2); };
        const auto endless = [&](std::size_t) {
            ++begun;
            for (;;) count_work(1);
        };
        CHECK_FALSE(unless_ended(ended, [&] {
            run_parallel(static_cast<std::size_t>(threads), threads, endless);
            return true;
        }));
        begun = 0;
        CHECK_FALSE(unless_ended(ended, [&] {
            run_on_threads(threads, [&] {
                run_both(
                    threads, [&] { endless(0); }, [&] { endless(1); });
            });
            return true;
        }));
        CHECK(unless_ended([] { return false; }, [] { return 5; }) == 5);
    }
}

}  // namespace candelabra
