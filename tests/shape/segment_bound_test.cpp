// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/segment_bound.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Case {
    std::string name;
    Shape shape;
    double enough;  ///< maximum area of the two halves of its box, as a fraction of its area
};

const std::vector<Case> cases = {
    {"cylinder aslant", Cylinder{Vec3(-1, -2, 0.5), Vec3(2, 1, 3), 0.05}, 0.6},
    {"cylinder along an axis", Cylinder{Vec3(0), Vec3(0, 3, 0), 0.2}, 1.4},
    {"cone", Cone{Vec3(1, 2, 3), 0.1, Vec3(-2, 0, 1), 0.02}, 0.7},
    {"box", Cuboid{Vec3(-3, 0, 0), Vec3(3, 0.1, 0.1)}, 1.3},
    {"sphere", Sphere{Vec3(1, 2, 3), 2}, 1.4},
};

/// A point of the surface, or none.
std::optional<Vec3> surface_point(const BuiltShape& shape, const Transform& map, Draw& draw) {
    const Stick stick = stick_around(shape, bounds(shape), nullptr);
    const Vec3 target = stick.from + draw.number() * (stick.to - stick.from);
    const Vec3 origin = target + 5.0 * draw.direction();
    Crossings found;
    crossings(shape, {origin, target - origin}, found);
    if (found.empty()) return {};
    return map.point(origin + found[0].t * (target - origin));
}

}  // namespace

TEST_CASE("the part of a long shape in a cell holds its surface there, and little more",
          "[shape]") {
    const Transform turned = Transform::rotation(Vec3(20, 30, 40));
    const Transform far = turned.then(Transform::scaling(Vec3(2, 1, 0.5)))
                              .then(Transform::translation(Vec3(1000, -500, 0)));
    for (const Case& c : cases) {
        const BuiltShape shape = built(c.shape);
        for (const Transform* map : {static_cast<const Transform*>(nullptr), &turned, &far}) {
            CAPTURE(c.name, map);
            const Stick stick = stick_around(shape, bounds(shape), map);
            const Transform placed = map ? *map : Transform();
            const Box whole = placed.box(bounds(shape));
            Draw draw(1);
            int seen = 0;
            for (int i = 0; i < 300; ++i) {
                const auto place = [&] {
                    const Vec3 share = 0.5 * (draw.point(1.2) + Vec3(1));
                    return whole.low + share * whole.size();
                };
                const Vec3 corner = place();
                const Box cell = join(Box{corner, corner}, place());
                const Box part = clipped_bounds(stick, cell);
                if (!part.empty()) CHECK((contains(cell, part.low) && contains(cell, part.high)));
                for (int k = 0; k < 20; ++k) {
                    const auto point = surface_point(shape, placed, draw);
                    if (!point || !contains(cell, *point)) continue;
                    ++seen;
                    const double pad = 1e-12 * (1 + max_abs_component(*point));
                    CHECK(contains(Box{part.low - Vec3(pad), part.high + Vec3(pad)}, *point));
                }
            }
            CHECK(seen > 100);
        }
    }
}

TEST_CASE("halves of shapes aslant have small boxes", "[shape]") {
    const Transform turned = Transform::rotation(Vec3(20, 30, 40));
    const auto share = [](const BuiltShape& shape, const Transform* map) {
        const Box whole = map ? map->box(bounds(shape)) : bounds(shape);
        const Vec3 size = whole.size();
        const int axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
        Box low = whole, high = whole;
        low.high[axis] = high.low[axis] = whole.centre()[axis];
        const Stick stick = stick_around(shape, bounds(shape), map);
        return (area(clipped_bounds(stick, low)) + area(clipped_bounds(stick, high))) / area(whole);
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        CHECK(share(built(c.shape), nullptr) < c.enough);
    }
    CHECK(share(built(Cuboid{Vec3(-3, 0, 0), Vec3(3, 0.1, 0.1)}), &turned) < 0.6);
    CHECK(share(built(Cylinder{Vec3(0), Vec3(0, 3, 0), 0.02}), &turned) < 0.6);
}

TEST_CASE("what a cell does not hold has no part in it", "[shape]") {
    const BuiltShape rod = built(Cylinder{Vec3(0), Vec3(4, 4, 4), 0.1});
    const Stick stick = stick_around(rod, bounds(rod), nullptr);
    CHECK(clipped_bounds(stick, Box{Vec3(3, 0, 0), Vec3(4, 1, 1)}).empty());
    CHECK(clipped_bounds(stick, Box{Vec3(5), Vec3(6)}).empty());
    CHECK(clipped_bounds(stick, Box{}).empty());
    const Box part = clipped_bounds(stick, Box{Vec3(1), Vec3(2)});
    CHECK(length(part.low - Vec3(1)) < 1e-12);
    CHECK(length(part.high - Vec3(2)) < 1e-12);
}

}  // namespace candelabra
