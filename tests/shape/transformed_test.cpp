// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/transformed.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a transformed plane has the points of the plane, transformed", "[shape]") {
    const Plane plane{Vec3(0, 2, 0), 3};
    const Transform map = Transform::scaling(Vec3(1, 4, 1))
                              .then(Transform::rotation(Vec3(0, 0, 90)))
                              .then(Transform::translation(Vec3(5, 0, 0)));
    const Plane placed = transformed(plane, map);
    CHECK(length(placed.normal) == Approx(1));
    for (const Vec3& on : {Vec3(0, 3, 0), Vec3(7, 3, -2)})
        CHECK(dot(placed.normal, map.point(on)) == Approx(placed.distance));
}

}  // namespace candelabra
