// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_rectangle.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a rectangle below the horizon is not drawn, and one that crosses it in part",
          "[luminaire]") {
    const Vec3 corner(-1, -1, 2), side1(2, 0, 0), side2(0, 2, 0), from(0, 0, 0);
    const auto seen = [&](const Vec3& normal) {
        return SeenRectangle(corner, side1, side2, from, &normal);
    };
    CHECK(seen(Vec3(0, 0, -1)).weight() == 0);
    CHECK(seen(Vec3(0, 0, 1)).weight() > 0);
    const SeenRectangle half = seen(Vec3(0, 1, 0));
    Draw draw(1);
    for (int i = 0; i < 200; ++i) {
        const auto drawn = half.draw({draw.number(), draw.number()});
        REQUIRE(drawn);
        CHECK(drawn->position.y > -1e-6);
    }
    const SeenRectangle all(corner, side1, side2, from, nullptr);
    CHECK(all.density(Vec3(0, 0, 1), 2) == Approx(half.density(Vec3(0, 0, 1), 2) / 2));
}

}  // namespace candelabra
