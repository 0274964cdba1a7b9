// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/box.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a box is empty until something is joined to it", "[base]") {
    const Box nothing;
    CHECK(nothing.empty());
    CHECK(area(nothing) == 0);
    const Box point = join(nothing, Vec3(1, 2, 3));
    CHECK_FALSE(point.empty());
    CHECK(point.size() == Vec3(0));
    CHECK(join(point, nothing).low == point.low);
    const Box box = join(point, Vec3(0, 4, 3));
    CHECK(box.low == Vec3(0, 2, 3));
    CHECK(box.high == Vec3(1, 4, 3));
    CHECK(box.centre() == Vec3(0.5, 3, 3));
    CHECK(area(box) == 4);
}

TEST_CASE("boxes that do not meet have nothing in common", "[base]") {
    const Box a{Vec3(0), Vec3(2)};
    CHECK(clip(a, Box{Vec3(1), Vec3(3)}).low == Vec3(1));
    CHECK(clip(a, Box{Vec3(1), Vec3(3)}).high == Vec3(2));
    CHECK(clip(a, Box{Vec3(2), Vec3(3)}).size() == Vec3(0));
    CHECK(clip(a, Box{Vec3(0, 0, 2.1), Vec3(3)}).empty());
}

TEST_CASE("distances of a point to a box", "[base]") {
    const Box box{Vec3(-1), Vec3(1)};
    struct Row {
        Vec3 point;
        bool contained;
        double nearest2, farthest2;
    };
    const std::vector<Row> table = {
        {Vec3(0), true, 0, 3},
        {Vec3(1), true, 0, 12},
        {Vec3(3, 0, 0), false, 4, 18},
        {Vec3(-2, -2, 0), false, 2, 19},
    };
    for (const Row& row : table) {
        CHECK(contains(box, row.point) == row.contained);
        CHECK(nearest_distance2(box, row.point) == row.nearest2);
        CHECK(farthest_distance2(box, row.point) == row.farthest2);
    }
}

TEST_CASE("a box is finite unless a side is away beyond all scenes", "[base]") {
    CHECK(finite(Box{Vec3(-1e29), Vec3(1)}));
    CHECK_FALSE(finite(Box{Vec3(-1), Vec3(1, 1, std::numeric_limits<double>::infinity())}));
    CHECK_FALSE(finite(Box{}));
}

}  // namespace candelabra
