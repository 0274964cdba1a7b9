// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.h"

#include <catch2/catch.hpp>

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

}  // namespace candelabra
