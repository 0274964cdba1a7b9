// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/vector.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("unit vectors have length 1, and zero stays zero", "[base]") {
    CHECK(unit(Vec3(0, -3, 4)) == Vec3(0, -0.6, 0.8));
    CHECK(unit(Vec3(0)) == Vec3(0));
    CHECK(length(Vec3(2, 3, 6)) == 7);
}

TEST_CASE("components", "[base]") {
    CHECK(max_component(Vec3(-5, 2, 1)) == 2);
    CHECK(min_component(Vec3(-5, 2, 1)) == -5);
    CHECK(max_abs_component(Vec3(-5, 2, 1)) == 5);
}

TEST_CASE("perpendiculars make a right-handed frame for every direction", "[base]") {
    Draw draw(1);
    for (int i = 0; i < 200; ++i) {
        Vec3 n = draw.direction();
        if (i < 6) {
            n = Vec3(0);
            n[i / 2] = i % 2 == 0 ? 1 : -1;
        }
        const auto [a, b] = perpendiculars(n);
        CHECK(length(cross(a, b) - n) < 1e-15);
        CHECK(length(a) == Approx(1).epsilon(1e-15));
        CHECK(length(b) == Approx(1).epsilon(1e-15));
    }
}

TEST_CASE("perpendiculars of a direction do not depend on the signs of its zeros", "[base]") {
    for (const Vec3& n : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.8, 0)}) {
        const Vec3 other(n.x == 0 ? -0.0 : n.x, n.y == 0 ? -0.0 : n.y, -0.0);
        CHECK(perpendiculars(n) == perpendiculars(other));
    }
}

}  // namespace candelabra
