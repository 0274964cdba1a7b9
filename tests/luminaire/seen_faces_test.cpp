// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_faces.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace {

const Box box{Vec3(-0.4, -0.3, -0.02), Vec3(0.4, 0.3, 0.02)};

}  // namespace

TEST_CASE("faces of a box are seen from outside only", "[luminaire]") {
    CHECK(SeenFaces(box, nullptr, Vec3(0, 0, 1), nullptr).any());
    CHECK_FALSE(SeenFaces(box, nullptr, Vec3(0.1, 0, 0), nullptr).any());
    // A point that rounding puts a little outside is on the face, and does not see it.
    CHECK_FALSE(SeenFaces(box, nullptr, Vec3(0.1, 0, 0.02 + 1e-15), nullptr).any());
}

TEST_CASE("drawn points have the density that is stated for them", "[luminaire]") {
    const Transform turn =
        Transform::rotation(Vec3(10, 40, 70)).then(Transform::translation(Vec3(3, 2, 1)));
    const Transform skew = Transform::scaling(Vec3(1, 2, 3)).then(Transform::rotation(Vec3(9)));
    Draw draw(1);
    for (const Transform* map : {static_cast<const Transform*>(nullptr), &turn, &skew})
        for (int i = 0; i < 40; ++i) {
            const Vec3 own = std::pow(10, draw.between(-0.6, 0.8)) * draw.direction();
            const Vec3 from = map ? map->point(own) : own;
            const SeenFaces faces(box, map, from, nullptr);
            if (!faces.any()) continue;
            // The mean of 1 / density is the solid angle; that of points seen through a wide
            // cone around a direction is at most the cone's.
            double solid_angle = 0;
            constexpr int steps = 24;
            for (int a = 0; a < steps; ++a)
                for (int b = 0; b < steps; ++b) {
                    const auto drawn = faces.draw({(a + 0.5) / steps, (b + 0.5) / steps});
                    REQUIRE(drawn);
                    const LightPoint& point = drawn->point;
                    const Vec3 offset = point.position - from;
                    CHECK(length(point.direction - unit(offset)) < 1e-12);
                    CHECK(faces.density(drawn->axis, unit(offset), length(offset)) ==
                          Approx(point.density).epsilon(1e-6));
                    solid_angle += 1 / point.density / (steps * steps);
                }
            double seen = 0;
            constexpr int views = 60000;
            Draw look(2);
            for (int k = 0; k < views; ++k) {
                const Ray ray{from, look.direction()};
                const Ray inside = map ? map->inverse_ray(ray) : ray;
                const Interval met = clip(inside, box, {});
                seen += met.min <= met.max ? 4 * 3.14159265 / views : 0;
            }
            CHECK(solid_angle == Approx(seen).epsilon(0.04).margin(0.03));
        }
}
