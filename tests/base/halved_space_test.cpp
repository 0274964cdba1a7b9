// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/halved_space.h"

#include <catch2/catch.hpp>

#include <optional>

namespace candelabra {

TEST_CASE("each part of halved space has the value of the places in it", "[base]") {
    CHECK(HalvedSpace().empty());
    std::vector<Vec3> places;
    for (int i = 0; i < 16; ++i) places.emplace_back((i * 7) % 16, 0.1 * (i % 3), 0);
    std::vector<std::size_t> counts;
    const HalvedSpace space(
        std::span<Vec3>{places}, [](const Vec3& place) { return place; },
        [&](std::span<const Vec3> part, const Vec3&, int) -> std::optional<double> {
            if (part.size() > 4) return std::nullopt;
            counts.push_back(part.size());
            double sum = 0;
            for (const Vec3& place : part) sum += place.x;
            return sum / 4;
        },
        [](std::span<const Vec3> part, int axis) {
            CHECK(axis == 0);
            return part.size() / 2;
        });
    CHECK(counts == std::vector<std::size_t>(4, 4));
    for (int x = 0; x < 16; ++x) CHECK(space.at(Vec3(x, 9, -9)) == x / 4 * 4 + 1.5);
    // Beyond all places, the nearest part along the axis counts.
    CHECK(space.at(Vec3(-99, 0, 0)) == 1.5);
    CHECK(space.at(Vec3(99, 0, 0)) == 13.5);
}

TEST_CASE("space that has a value at once is not halved", "[base]") {
    std::vector<Vec3> places(3, Vec3(1));
    const HalvedSpace space(
        std::span<Vec3>{places}, [](const Vec3& place) { return place; },
        [](std::span<const Vec3> part, const Vec3& size, int) -> std::optional<double> {
            CHECK(size == Vec3(0));
            return static_cast<double>(part.size());
        },
        [](std::span<const Vec3>, int) { return std::size_t{1}; });
    CHECK_FALSE(space.empty());
    CHECK(space.at(Vec3(0)) == 3);
}

}  // namespace candelabra
