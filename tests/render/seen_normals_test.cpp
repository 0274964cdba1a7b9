// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen_normals.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("normals are those of the first surfaces, towards the camera", "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        camera { location <0, 0, -5> look_at 0 right x up y angle 53.13 }
        plane { -z, 0 clipped_by { plane { x, 0 } } }
        plane { <1, 0, 1>, 0 clipped_by { plane { -x, 0 } } clipped_by { plane { y, 0 } } }
    )");
    const auto normals = seen_normals(shot, 4, 4, 2);
    REQUIRE(normals.size() == 48);
    const auto normal = [&](std::size_t x, std::size_t y) {
        const std::size_t at = 3 * (4 * y + x);
        return Vec3(normals[at], normals[at + 1], normals[at + 2]);
    };
    CHECK(normal(0, 0) == Vec3(0, 0, -127));
    CHECK(normal(3, 0) == Vec3(0));
    CHECK(normal(3, 3) == Vec3(-90, 0, -90));
    CHECK(seen_normals(shot, 4, 4, 1) == normals);
}

TEST_CASE("a pixel at an edge has the mean of two normals", "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        camera { orthographic location <0, 0, -5> look_at 0 right 3*x up y }
        plane { -z, 0 clipped_by { plane { x, 0 } } }
    )");
    const auto normals = seen_normals(shot, 3, 1, 1);
    CHECK(normals[2] == -127);
    CHECK(normals[5] == -64);
    CHECK(normals[8] == 0);
}

}  // namespace candelabra
