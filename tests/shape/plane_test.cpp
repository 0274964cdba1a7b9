// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/plane.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the distance of a plane counts along its unit normal", "[shape]") {
    const Plane up{Vec3(0, 2, 0), 3}, down{Vec3(0, -1, 0), 3};
    CHECK(answers(up, {{Vec3(7, 10, 7), Vec3(0, -1, 0)}, {{7, Vec3(0, 1, 0), true}}}));
    CHECK(answers(up, {{Vec3(7, 0, 7), Vec3(0, 0.5, 1)}, {{6, Vec3(0, 1, 0), false}}}));
    CHECK(answers(up, {{Vec3(0, 10, 0), Vec3(1, 0, 0)}, {}}));
    CHECK(answers(down, {{Vec3(0, 10, 0), Vec3(0, -1, 0)}, {{13, Vec3(0, -1, 0), false}}}));
    CHECK(inside(up, Vec3(0, 2.9, 0)));
    CHECK_FALSE(inside(up, Vec3(0, 3.1, 0)));
    CHECK_FALSE(inside(down, Vec3(0, -4, 0)));
    CHECK(inside(down, Vec3(0)));
    CHECK_FALSE(finite(bounds(up)));
}

TEST_CASE("a plane needs a direction", "[shape]") {
    const std::string sentence = "a `plane` needs a normal with a length above 0 and below 1e150";
    CHECK(problem(Plane{}) == "");
    CHECK(problem(Plane{Vec3(1e-100, 0, 0), 0}) == "");
    CHECK(problem(Plane{Vec3(0), 0}) == sentence);
    CHECK(problem(Plane{Vec3(1e200), 0}) == sentence);
    CHECK(problem(Plane{Vec3(std::nan("")), 0}) == sentence);
}

}  // namespace candelabra
