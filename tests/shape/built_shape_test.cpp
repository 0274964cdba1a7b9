// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/built_shape.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a built shape answers rays as its kind does", "[shape]") {
    const Sphere sphere{Vec3(1, 0, 0), 2};
    const BuiltShape ready = built(Shape(sphere));
    REQUIRE(std::get_if<Sphere>(&ready));
    CHECK(bounds(ready).low == Vec3(-1, -2, -2));
    CHECK(inside(ready, Vec3(2.5, 0, 0)));
    CHECK_FALSE(inside(ready, Vec3(-1.5, 0, 0)));
    Crossings found;
    crossings(ready, {Vec3(-5, 0, 0), Vec3(1, 0, 0)}, found);
    CHECK(found.size() == 2);
}

TEST_CASE("the box of the inside of a plane is a half space, that of its surface is all",
          "[shape]") {
    const BuiltShape ground = built(Shape(Plane{Vec3(0, 1, 0), 0}));
    CHECK(inside_bounds(ground).high.y <= 1e-6);
    CHECK(inside_bounds(ground).low.x == -std::numeric_limits<double>::infinity());
}

TEST_CASE("the foot of a shape is met where a plane in its place is, to the last digit",
          "[shape]") {
    const Vec3 foot(0.3, 0.7, -0.2), top(0.3, 2.3, -0.2);
    const std::vector<Vec2> profile = {{0, 0.7}, {1, 0.7}, {0.6, 1.1}, {0, 2.3}};
    const Shape shapes[] = {Cylinder{foot, top, 1}, Cylinder{top, foot, 1}, Cone{foot, 1, top, 0.4},
                            Lathe{linear_curve, profile},
                            Sor{{{0.2, -0.1}, {0.8, 0.7}, {0.6, 1.1}, {0.8, 2.3}, {1, 3}}}};
    const Plane floor{Vec3(0, 1, 0), 0.7};
    for (const Shape& each : shapes) {
        const BuiltShape shape = built(each);
        for (int i = 0; i < 40; ++i) {
            const Vec3 from(0.01 * i, 1.1 + 0.007 * i, 0.013 * i - 0.3);
            const Ray down{from, unit(Vec3(0.1, -1.7, 0.3) - from)};
            Crossings of_shape, of_floor;
            crossings(shape, down, of_shape);
            crossings(floor, down, of_floor);
            double last = 0;
            for (std::size_t k = 0; k < of_shape.size(); ++k) last = std::fmax(last, of_shape[k].t);
            CHECK(last == of_floor[0].t);
        }
    }
}

}  // namespace candelabra
