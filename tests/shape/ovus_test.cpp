// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/ovus.h"

#include "support/axes.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {}  // namespace

TEST_CASE("an ovus has the bounds and the inside that POV-Ray gives it", "[shape]") {
    const Ovus egg{1, 0.7};
    CHECK(length(bounds(egg).high - Vec3(1.0121, 1.7, 1.0121)) < 1e-4);
    CHECK(length(bounds(egg).low - Vec3(-1.0121, -1, -1.0121)) < 1e-4);
    CHECK(inside(egg, Vec3(0)));
    CHECK(inside(egg, Vec3(0, 1.65, 0)));
    CHECK_FALSE(inside(egg, Vec3(0, 1.75, 0)));
    CHECK(answers(egg, {{5.0 * y, -y}, {{3.3, y, true}, {6, -y, false}}}));
}

TEST_CASE("spheres and arc of an ovus are joined without a gap and without an edge", "[shape]") {
    for (const Ovus& egg : {Ovus{1, 0.7}, Ovus{1, 0.1}, Ovus{1, 1}, Ovus{1, 1.8}, Ovus{3, 2}}) {
        Vec3 before(0);
        for (double h = -egg.bottom_radius + 1e-3; h < egg.bottom_radius + egg.top_radius;
             h += 1e-3) {
            const auto found = hits(egg, {Vec3(-10, h, 0), x});
            REQUIRE(found.size() == 2);
            const double bend = length(found[0].normal - before);
            if (before != Vec3(0)) CHECK(bend < 0.07 / std::fmin(1, std::sqrt(egg.top_radius)));
            before = found[0].normal;
        }
    }
}

TEST_CASE("an ovus with a top too large is a sphere", "[shape]") {
    CHECK(answers(Ovus{1, 2}, {{Vec3(-5, 1, 0), x}, {{3, -x, true}, {7, x, false}}}));
    CHECK(bounds(Ovus{1, 2.5}).high == Vec3(2.5, 3.5, 2.5));
    CHECK(inside(Ovus{1, 2.5}, Vec3(0, 3.4, 0)));
}

TEST_CASE("an ovus with one radius of 0 is a sphere", "[shape]") {
    CHECK(answers(Ovus{1, 0}, {{Vec3(-5, 0.5, 0), x},
                               {{5 - std::sqrt(0.75), Vec3(-std::sqrt(0.75), 0.5, 0), true},
                                {5 + std::sqrt(0.75), Vec3(std::sqrt(0.75), 0.5, 0), false}}}));
    CHECK(answers(Ovus{0, 1}, {{Vec3(-5, 0, 0), x}, {{4, -x, true}, {6, x, false}}}));
    CHECK(answers(Ovus{0, 0}, {{Vec3(-5, 0, 0), x}, {}}));
}

}  // namespace candelabra
