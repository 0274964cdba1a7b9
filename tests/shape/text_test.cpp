// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/text.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("letters stand in the plane of x and y, and go backwards", "[shape]") {
    Text text;
    CHECK(problem(text) == "a `text` needs `ttf` or `internal`");
    text.font = "a.ttf";
    CHECK(vanishes(text) == "it has no visible letter");
    text.thickness = 0.5;
    text.letters = make_handle<Letters>(
        Letters{{curve(linear_curve, std::array{Vec2(0, 0), Vec2(1, 0), Vec2(1, 2), Vec2(0, 0)})}});
    const BuiltText built = build(text);
    const Vec3 z(0, 0, 1);
    CHECK(answers(built, {{Vec3(0.6, 0.5, -1), z}, {{1, -z, true}, {1.5, z, false}}}));
    CHECK(bounds(built).high == Vec3(1, 2, 0.5));
    CHECK(inside(built, Vec3(0.6, 0.5, 0.2)));
    CHECK_FALSE(inside(built, Vec3(0.2, 0.5, 0.2)));
}

}  // namespace candelabra
