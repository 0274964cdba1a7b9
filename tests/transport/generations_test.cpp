// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/generations.h"

#include "base/parallel.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

namespace {

/// Its generations are their numbers.
struct CountedSource {
    int made = 0;
    static constexpr std::uint32_t single_samples = 0, shared_samples = 4;
    std::shared_ptr<const std::uint32_t> generation(std::uint32_t number) {
        ++made;
        return std::make_shared<const std::uint32_t>(number);
    }
};

}  // namespace

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

TEST_CASE("the first samples have a generation each, later ones share theirs", "[transport]") {
    const std::vector<std::uint32_t> expected = {0, 1, 2, 3, 3, 3, 3, 4};
    for (std::uint32_t sample = 0; sample < expected.size(); ++sample)
        CHECK(generation_serving(sample, 3, 4) == expected[sample]);
}

TEST_CASE("a job keeps the generation that serves its samples", "[transport]") {
    CHECK_FALSE(ServedGeneration<CountedSource>());
    const auto source = std::make_shared<CountedSource>();
    ServedGeneration<CountedSource> served(source);
    REQUIRE(served);
    for (std::uint32_t sample = 0; sample < 12; ++sample) {
        CHECK(*served.begin(sample) == sample / 4);
        CHECK(served.current() == sample / 4);
    }
    CHECK(source->made == 3);
    served.prepare(13);
    CHECK(source->made == 4);
    ServedGeneration<CountedSource> none;
    none.prepare(13);
    CHECK(none.begin(13) == nullptr);
}

}  // namespace candelabra
