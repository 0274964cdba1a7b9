// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_faces.h"

#include "support/draw.h"

#include <catch2/catch.hpp>
#include <set>

namespace candelabra {

namespace {

const Box box{Vec3(-0.4, -0.3, -0.02), Vec3(0.4, 0.3, 0.02)};

}  // namespace

TEST_CASE("a point sees the faces that face it, from within all but those that it lies on",
          "[luminaire]") {
    const auto seen = [](const Vec3& from) {
        const SeenFaces faces(box, nullptr, from, nullptr);
        std::set<int> found;
        Draw draw(3);
        for (int i = 0; i < 2000 && faces.any(); ++i)
            if (const auto drawn = faces.draw({draw.number(), draw.number()}))
                found.insert(drawn->face);
        return found;
    };
    CHECK(seen(Vec3(0, 0, 1)) == std::set{5});
    CHECK(seen(Vec3(-1, 0, 1)) == std::set{0, 5});
    CHECK(seen(Vec3(0.1, 0, 0)) == std::set{0, 1, 2, 3, 4, 5});
    for (const double rounding : {-1e-15, 0.0, 1e-15})
        CHECK(seen(Vec3(0.1, 0, 0.02 + rounding)) == std::set{0, 1, 2, 3, 4});
}

TEST_CASE("drawn points have the density that is stated for them", "[luminaire]") {
    const Transform turn =
        Transform::rotation(Vec3(10, 40, 70)).then(Transform::translation(Vec3(3, 2, 1)));
    const Transform skew = Transform::scaling(Vec3(1, 2, 3)).then(Transform::rotation(Vec3(9)));
    Draw draw(1);
    for (const Transform* map : {static_cast<const Transform*>(nullptr), &turn, &skew})
        for (int i = 0; i < 40; ++i) {
            const Vec3 own = std::pow(10, draw.between(-2.5, 0.8)) * draw.direction();
            const Vec3 from = map ? map->point(own) : own;
            const SeenFaces faces(box, map, from, nullptr);
            if (!faces.any()) continue;
            // The mean of 1 / density is the solid angle. For points seen through a wide cone
            // around a direction it is at most the cone's.
            double solid_angle = 0;
            constexpr int steps = 24;
            for (int a = 0; a < steps; ++a)
                for (int b = 0; b < steps; ++b) {
                    const auto drawn = faces.draw({(a + 0.5) / steps, (b + 0.5) / steps});
                    REQUIRE(drawn);
                    const LightPoint& point = drawn->point;
                    const Vec3 offset = point.position - from;
                    CHECK(length(point.direction - unit(offset)) < 1e-12);
                    CHECK(faces.density(drawn->face, unit(offset), length(offset)) ==
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

TEST_CASE("what is below the horizon is not drawn, and all above it is", "[luminaire]") {
    Draw draw(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 from = std::pow(10, draw.between(-0.4, 0.6)) * draw.direction();
        // Horizons that cut the box, some of them along its faces.
        Vec3 normal = unit(cross(draw.direction(), from));
        if (i % 3 == 0) normal = i % 2 == 0 ? Vec3(0, 0, 1) : Vec3(0, -1, 0);
        const SeenFaces faces(box, nullptr, from, &normal);
        const SeenFaces all(box, nullptr, from, nullptr);
        for (int k = 0; k < 60 && all.any(); ++k) {
            const auto drawn = all.draw({draw.number(), draw.number()});
            if (!drawn || !(dot(drawn->point.direction, normal) > 0)) continue;
            REQUIRE(faces.any());
            CHECK(faces.density(drawn->face, drawn->point.direction, drawn->point.distance) > 0);
        }
        // Fraction of the draws above the horizon: all of them if it runs along an edge.
        int above = 0, count = 0;
        for (int k = 0; k < 100 && faces.any(); ++k)
            if (const auto drawn = faces.draw({draw.number(), draw.number()})) {
                ++count;
                above += dot(drawn->point.direction, normal) > -1e-6;
            }
        if (i % 3 == 0) CHECK(above == count);
    }
}

TEST_CASE("the light of a box that the horizon cuts is the same by all its parts", "[luminaire]") {
    Draw draw(6);
    for (int i = 0; i < 30; ++i) {
        const Vec3 from = std::pow(10, draw.between(-0.3, 0.5)) * draw.direction();
        const Vec3 normal = unit(unit(cross(draw.direction(), from)) - 0.2 * unit(from));
        const auto light = [&](const Vec3* horizon) {
            const SeenFaces faces(box, nullptr, from, horizon);
            double sum = 0;
            constexpr int steps = 120;
            for (int a = 0; a < steps && faces.any(); ++a)
                for (int b = 0; b < steps; ++b)
                    if (const auto drawn = faces.draw({(a + 0.5) / steps, (b + 0.5) / steps}))
                        sum += std::fmax(dot(drawn->point.direction, normal), 0) /
                               drawn->point.density / (steps * steps);
            return sum;
        };
        CHECK(light(&normal) == Approx(light(nullptr)).epsilon(0.02).margin(1e-3));
    }
}

}  // namespace candelabra
