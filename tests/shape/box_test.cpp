// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/box.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rays cross a box where they should", "[shape]") {
    const Cuboid cuboid{Vec3(1, 1, 1), Vec3(-1, -2, -3)};
    const std::vector<RayCase> table = {
        {{Vec3(0, 0, -5), Vec3(0, 0, 1)}, {{2, Vec3(0, 0, -1), true}, {6, Vec3(0, 0, 1), false}}},
        {{Vec3(0, 5, 0), Vec3(0, -2, 0)}, {{2, Vec3(0, 1, 0), true}, {3.5, Vec3(0, -1, 0), false}}},
        {{Vec3(0), Vec3(1, -0.0, 0)}, {{-1, Vec3(-1, 0, 0), true}, {1, Vec3(1, 0, 0), false}}},
        {{Vec3(-2, 0, 0), Vec3(1, 1, 0)}, {}},
        {{Vec3(-1.5, 0, 0), Vec3(1, 1, 0)},
         {{0.5, Vec3(-1, 0, 0), true}, {1, Vec3(0, 1, 0), false}}},
        {{Vec3(0, 1, 5), Vec3(0, 0, -1)}, {{4, Vec3(0, 0, 1), true}, {8, Vec3(0, 0, -1), false}}},
        {{Vec3(0, 1.0000001, 5), Vec3(0, 0, -1)}, {}},
        {{Vec3(0), Vec3(0)}, {}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(cuboid, table[i]));
    }
}

TEST_CASE("a box without thickness is entered and left at once", "[shape]") {
    const Cuboid sheet{Vec3(0, 0, 0), Vec3(1, 1, 0)};
    CHECK(answers(sheet, {{Vec3(0.5, 0.5, -1), Vec3(0, 0, 1)},
                          {{1, Vec3(0, 0, -1), true}, {1, Vec3(0, 0, 1), false}}}));
    CHECK(answers(sheet, {{Vec3(1.5, 0.5, -1), Vec3(0, 0, 1)}, {}}));
}

TEST_CASE("the surface of a box is inside it", "[shape]") {
    const Cuboid cuboid{Vec3(1, 1, 1), Vec3(-1, -2, -3)};
    CHECK(inside(cuboid, Vec3(1, 1, 1)));
    CHECK(inside(cuboid, Vec3(0)));
    CHECK_FALSE(inside(cuboid, Vec3(1.001, 0, 0)));
    CHECK(bounds(cuboid).low == Vec3(-1, -2, -3));
    CHECK(bounds(cuboid).high == Vec3(1, 1, 1));
}

}  // namespace candelabra
