// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/built_shape.h"

#include "support/draw.h"
#include "support/hits.h"
#include "support/shapes.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEMPLATE_LIST_TEST_CASE("a built shape answers rays as its kind does", "[shape]", Shape) {
    using T = ContentOf<TestType>;
    Draw draw(5);
    for (const T& instance : shape_table::instances<T>()) {
        const auto& own = ready(instance);
        const BuiltShape any = built(Shape(TestType(instance)));
        CHECK(bounds(any).low == bounds(own).low);
        CHECK(bounds(any).high == bounds(own).high);
        const Box box = shape_table::region(own);
        const double size = length(box.size());
        for (int i = 0; i < 50; ++i) {
            const Vec3 share = 0.5 * (draw.point(1) + Vec3(1));
            const Vec3 target = box.low + share * box.size(), way = draw.direction();
            CHECK(inside(any, target) == inside(own, target));
            const Ray ray{target - size * way, way};
            const std::vector<Crossing> expected = hits(own, ray), found = hits(any, ray);
            REQUIRE(found.size() == expected.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                CHECK(found[k].t == expected[k].t);
                CHECK(found[k].normal == expected[k].normal);
            }
        }
    }
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
