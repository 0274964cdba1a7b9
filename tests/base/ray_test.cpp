// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ray.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a ray is clipped to a box", "[base]") {
    const Box box{Vec3(-1, -2, -3), Vec3(1, 2, 3)};
    struct Row {
        Ray ray;
        double min, max;  ///< min above max: the ray misses
    };
    const std::vector<Row> table = {
        {{Vec3(-5, 0, 0), Vec3(1, 0, 0)}, 4, 6},    {{Vec3(-5, 0, 0), Vec3(2, 0, 0)}, 2, 3},
        {{Vec3(5, 0, 0), Vec3(-1, 0, 0)}, 4, 6},    {{Vec3(0), Vec3(0, 1, 0)}, 0, 2},
        {{Vec3(0, 0, -4), Vec3(0.25, 0, 1)}, 1, 4}, {{Vec3(1, 0, -4), Vec3(0, 0, 1)}, 1, 7},
        {{Vec3(-1, 2, -4), Vec3(0, 0, 1)}, 1, 7},   {{Vec3(1.01, 0, -4), Vec3(0, 0, 1)}, 1, 0},
        {{Vec3(5, 0, 0), Vec3(1, 0, 0)}, 1, 0},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        const Interval part = clip(table[i].ray, box, Interval{0, 100});
        if (table[i].min > table[i].max)
            CHECK(part.min > part.max);
        else
            CHECK((part.min == table[i].min && part.max == table[i].max));
    }
}

TEST_CASE("intervals are open", "[base]") {
    const Interval range{1, 2};
    CHECK(range.contains(1.5));
    CHECK_FALSE(range.contains(1));
    CHECK_FALSE(range.contains(2));
    CHECK(Interval{}.contains(1e300));
    CHECK_FALSE(Interval{}.contains(0));
}

TEST_CASE("crossings keep their order beyond what fits in place", "[base]") {
    Crossings found;
    CHECK(found.empty());
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < 20; ++i) found.add({static_cast<double>(i), Vec3(i), i % 2 == 0});
        REQUIRE(found.size() == 20);
        for (std::size_t i = 0; i < 20; ++i) {
            CHECK(found[i].t == static_cast<double>(i));
            CHECK(found[i].entering == (i % 2 == 0));
        }
        found.clear();
        CHECK(found.empty());
    }
}

}  // namespace candelabra
