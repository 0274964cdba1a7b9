// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/part_index.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<Box> boxes(std::size_t count, Draw& draw) {
    std::vector<Box> result;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 corner = draw.point(3);
        result.push_back({corner, corner + glm::abs(draw.point(1))});
    }
    return result;
}

}  // namespace

TEST_CASE("each part is found once, by rays and by points", "[shape]") {
    Draw draw(1);
    for (const std::size_t count : {0u, 1u, 7u, 9u, 500u, 5000u}) {
        const auto all = boxes(count, draw);
        const PartIndex index(all);
        for (int i = 0; i < 300; ++i) {
            const Ray ray{draw.point(4), draw.direction()};
            const Interval range{draw.between(-2, 0), draw.between(0, 5)};
            std::vector<std::uint32_t> expected, found;
            for (std::uint32_t k = 0; k < count; ++k) {
                const Interval within = clip(ray, all[k], range);
                if (within.min <= within.max) expected.push_back(k);
            }
            index.along(ray, range, [&](std::uint32_t k) { found.push_back(k); });
            CHECK(found == expected);

            expected.clear();
            found.clear();
            for (std::uint32_t k = 0; k < count; ++k)
                if (contains(all[k], ray.origin)) expected.push_back(k);
            index.around(ray.origin, [&](std::uint32_t k) { found.push_back(k); });
            CHECK(found == expected);
        }
    }
}

TEST_CASE("flat parts are found by rays that pass through them", "[shape]") {
    const PartIndex index(std::vector<Box>(20, Box{Vec3(0, 1, 0), Vec3(1, 1, 1)}));
    std::size_t found = 0;
    index.along({Vec3(0.5, 5, 0.5), Vec3(0, -1, 0)}, {0, 10}, [&](std::uint32_t) { ++found; });
    CHECK(found == 20);
    CHECK(index.bounds().high == Vec3(1));
}

}  // namespace candelabra
