// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/rectangle.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

RectangleEmitter random_rectangle(Draw& draw) {
    const Vec3 along = draw.direction();
    const auto [x, y] = perpendiculars(along);
    return {draw.point(), draw.between(0.1, 2) * x, draw.between(0.1, 2) * y};
}

}  // namespace

TEST_CASE("a rectangle's irradiance and samples agree with those of its parts", "[luminaire]") {
    Draw draw(1);
    for (int i = 0; i < 100; ++i) {
        const RectangleEmitter r = random_rectangle(draw);
        const Receiver point{r.corner + draw.between(0.2, 3) * draw.direction(), draw.direction(),
                             i % 2 ? Horizon::one_side : Horizon::both_sides};
        double of_parts = 0, of_samples = 0;
        constexpr int steps = 60;
        for (int a = 0; a < steps; ++a)
            for (int b = 0; b < steps; ++b) {
                const Vec2 u{(a + 0.5) / steps, (b + 0.5) / steps};
                const Vec3 offset = r.corner + u.x * r.side1 + u.y * r.side2 - point.position;
                const double d2 = dot(offset, offset), height = dot(offset, point.normal);
                if (height > 0 || point.horizon != Horizon::one_side)
                    of_parts += std::abs(height * dot(offset, cross(r.side1, r.side2))) / (d2 * d2);
                const auto drawn = sample(r, point, u);
                if (!drawn) continue;
                const double cosine = dot(drawn->direction, point.normal);
                of_samples +=
                    (point.horizon == Horizon::one_side ? std::fmax(cosine, 0) : std::abs(cosine)) /
                    drawn->density;
            }
        CAPTURE(i);
        const double whole = unoccluded(r, 1, point);
        CHECK(of_samples / (steps * steps) == Approx(whole).epsilon(0.02).margin(1e-3));
        // Sums over equal parts of the area are good only from some distance.
        if (length(bounds(r, 1).centre - point.position) > 1.2 * bounds(r, 1).radius)
            CHECK(of_parts / (steps * steps) == Approx(whole).epsilon(0.02).margin(1e-3));
    }
}

TEST_CASE("points of a rectangle are met where they are drawn, with their density", "[luminaire]") {
    Draw draw(2);
    for (int i = 0; i < 300; ++i) {
        const RectangleEmitter r = random_rectangle(draw);
        const Receiver point{3.0 * draw.point(), draw.direction(), lit_from(i % 2 == 0)};
        const auto drawn = sample(r, point, {draw.number(), draw.number()});
        if (!drawn) continue;
        LightHits met;
        intersect(r, point, drawn->direction, met);
        REQUIRE(met.size() == 1);
        CHECK(met[0].distance == Approx(drawn->distance));
        CHECK(met[0].density == Approx(drawn->density));
    }
}

TEST_CASE("hardly any sample of a rectangle is large, however near it is", "[luminaire]") {
    const RectangleEmitter r{Vec3(-1, 0, -0.1), Vec3(2, 0, 0), Vec3(0, 0, 0.2)};
    for (const double height : {0.1, 0.01, 1e-3, 1e-4}) {
        const Receiver point{Vec3(0.2, height, 0.05), Vec3(0, 0, 1), Horizon::one_side};
        const double whole = unoccluded(r, 1, point);
        double greatest = 0;
        Draw draw(3);
        for (int i = 0; i < 1000; ++i)
            if (const auto drawn = sample(r, point, {draw.number(), draw.number()}))
                greatest =
                    std::fmax(greatest, dot(drawn->direction, point.normal) / drawn->density);
        CAPTURE(height);
        CHECK(greatest < 4 * whole);
    }
}

}  // namespace candelabra
