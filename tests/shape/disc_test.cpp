// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/disc.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rays cross a disc where they should", "[shape]") {
    const Disc ring{Vec3(0), Vec3(0, 3, 0), 2, 0.5};
    const std::vector<RayCase> table = {
        {{Vec3(1, 5, 0), Vec3(0, -1, 0)}, {{5, Vec3(0, 1, 0), true}}},
        {{Vec3(1, -5, 0), Vec3(0, 2, 0)}, {{2.5, Vec3(0, 1, 0), false}}},
        {{Vec3(0.2, 5, 0), Vec3(0, -1, 0)}, {}},
        {{Vec3(2.1, 5, 0), Vec3(0, -1, 0)}, {}},
        {{Vec3(-5, 0, 0), Vec3(1, 0, 0)}, {}},
        {{Vec3(0, 1, 0), Vec3(1, -1, 0)}, {{1, Vec3(0, 1, 0), true}}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(ring, table[i]));
    }
}

TEST_CASE("the half space behind a disc is its inside", "[shape]") {
    const Disc disc{Vec3(1, 2, 3), Vec3(0, 1, 0), 1, 0};
    CHECK(inside(disc, Vec3(100, 1.9, 0)));
    CHECK_FALSE(inside(disc, Vec3(1, 2, 3)));
    CHECK_FALSE(inside(disc, Vec3(1, 2.1, 3)));
}

TEST_CASE("bounds of a disc are tight", "[shape]") {
    const Box flat = bounds(Disc{Vec3(1, 2, 3), Vec3(0, 5, 0), 2, 0});
    CHECK(flat.low == Vec3(-1, 2, 1));
    CHECK(flat.high == Vec3(3, 2, 5));
    const Box tilted = bounds(Disc{Vec3(0), Vec3(1, 1, 0), 1, 0});
    CHECK(length(tilted.high - Vec3(std::sqrt(0.5), std::sqrt(0.5), 1)) < 1e-15);
}

TEST_CASE("a disc needs a direction and something around its hole", "[shape]") {
    CHECK(problem(Disc{}) == "");
    CHECK(problem(Disc{Vec3(0), Vec3(0), 1, 0}) ==
          "a `disc` needs a normal with a length above 0 and below 1e150");
    CHECK(vanishes(Disc{Vec3(0), Vec3(0, 1, 0), 1, 1}) == "its hole is as wide as itself");
    CHECK(vanishes(Disc{}).empty());
}

}  // namespace candelabra
