// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/ray_start.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a ray begins on a surface whose tangent plane holds its origin", "[shape]") {
    const double size = 6371, rounding = size * 0x1p-50;
    const Vec3 up(0, 3, 0);
    for (const double cosine : {1.0, 1e-3, 1e-8}) {
        const Ray flat{Vec3(0, rounding, 0), Vec3(std::sqrt(1 - cosine * cosine), -cosine, 0)};
        CHECK(begins_on(flat, rounding / cosine, up, size));
        // What lies there in front of another object is met.
        const Ray above{Vec3(0, 1e-6, 0), flat.direction};
        CHECK_FALSE(begins_on(above, 1e-6 / cosine, up, size));
    }
}

TEST_CASE("infinite coordinates of a box do not make it large", "[shape]") {
    CHECK(largest_coordinate(everywhere()) == 0);
    CHECK(largest_coordinate({Vec3(-1, -infinity, 2), Vec3(3, infinity, 4)}) == 4);
    CHECK(largest_coordinate({Vec3(-7, -1, 2), Vec3(3, 5, 4)}) == 7);
}

TEST_CASE("an infinite shape is as large as its own coordinates near the ray", "[shape]") {
    const Transform scaled =
        Transform::scaling(Vec3(1000)).then(Transform::translation(Vec3(0, -1000, 0)));
    CHECK(crossing_size(everywhere(), &scaled, Vec3(0, 0.1, 0)) == Approx(2000.1));
    CHECK(crossing_size(everywhere(), nullptr, Vec3(0, 0.1, 0)) == 0);
    CHECK(crossing_size({Vec3(-7), Vec3(3)}, &scaled, Vec3(0, 0.1, 0)) == 7);
}

}  // namespace candelabra
