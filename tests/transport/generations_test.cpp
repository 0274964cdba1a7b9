// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/generations.h"

#include "base/parallel.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

TEST_CASE("a generation is made once, whoever asks for it", "[transport]") {
    Generations<int> generations(4);
    std::atomic<int> made = 0;
    std::atomic<bool> wrong = false;
    run_parallel(64, 4, [&](std::size_t i) {
        const auto number = static_cast<std::uint32_t>(i % 3);
        const auto got = generations.get(number, [&] {
            ++made;
            return static_cast<int>(10 * number);
        });
        if (*got != static_cast<int>(10 * number)) wrong = true;
    });
    CHECK(made == 3);
    CHECK_FALSE(wrong);
}

TEST_CASE("old generations are forgotten, and made again", "[transport]") {
    Generations<int> generations(2);
    int made = 0;
    const auto ask = [&](std::uint32_t number) {
        return *generations.get(number, [&] {
            ++made;
            return static_cast<int>(number);
        });
    };
    for (const std::uint32_t number : {0u, 1u, 2u, 2u, 1u}) CHECK(ask(number) == int(number));
    CHECK(made == 3);
    CHECK(ask(0) == 0);
    CHECK(made == 4);
}

}  // namespace candelabra
