// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/luminaire.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

TEST_CASE("luminance is above 0 when any channel is, and drops what is below 0", "[luminaire]") {
    CHECK(luminance(Rgb(0)) == 0);
    CHECK(luminance(Rgb(-1, -2, -3)) == 0);
    CHECK(luminance(Rgb(1)) == Approx(1));
    CHECK(luminance(Rgb(-5, 0, 2)) == Approx(luminance(Rgb(0, 0, 2))));
    CHECK(luminance(Rgb(0, 0, 1e-320)) > 0);
    CHECK(std::isfinite(luminance(Rgb(1e308))));
}

TEST_CASE("no luminaire is estimated at 0 where a part of it is above the horizon",
          "[luminaire][claim-9]") {
    // The paper's Figure 4, for 10^5 random luminaires, points and normals; most straddle the
    // tangent plane.
    Draw draw(1);
    int lit = 0, straddling = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 place = draw.point(10);
        const double size = std::pow(10, draw.between(-3, 1));
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, place, size, draw));
        Receiver point{point_around(place, size, draw), draw.direction(), lit_from(i % 11 == 0)};
        const auto s = sample(luminaire, point.position, {draw.number(), draw.number()});
        if (!s) continue;
        // Tilted so that the sampled point is just above the horizon.
        if (i % 2 == 0)
            point.normal = unit(cross(cross(s->direction, point.normal), s->direction) +
                                1e-3 * draw.number() * s->direction);
        const double cosine = dot(s->direction, point.normal);
        if (!(cosine > 1e-12) && point.horizon == Horizon::one_side) continue;
        ++lit;
        straddling += dot(point.normal, place - point.position) < 0;
        const double estimate = unoccluded(luminaire, point);
        if (!(estimate > 0)) INFO(i % emitter_kinds << " " << size);
        if (!(estimate > 0)) CHECK(estimate > 0);
    }
    CHECK(lit > 50000);
    CHECK(straddling > 5000);
}

TEST_CASE("in the air a luminaire counts by the solid angle that it fills", "[luminaire]") {
    Draw draw(7);
    for (int i = 0; i < 600; ++i) {
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, Vec3(0), 1, draw));
        const LightBounds b = bounds(luminaire);
        const double away = b.radius * draw.between(2, 20);
        const Receiver point{b.centre + away * draw.direction(), Vec3(0), Horizon::none};
        const double found = sampled_irradiance(luminaire, point, 60);
        CAPTURE(i % emitter_kinds, away);
        // Choosing luminaires needs no more than the order of magnitude.
        if (found > 0) CHECK(unoccluded(luminaire, point) > 0.2 * found);
        CHECK(unoccluded(luminaire, point) < 5 * found + b.intensity / (away * away));
    }
    const SphereEmitter sphere{Vec3(0), 1};
    const Receiver far{Vec3(50, 0, 0), Vec3(0), Horizon::none};
    CHECK(unoccluded(sphere, 1, far) == Approx(std::numbers::pi / 2500).epsilon(1e-3));
    const Receiver within{Vec3(0.3, 0, 0), Vec3(0), Horizon::none};
    CHECK(unoccluded(sphere, 1, within) == Approx(4 * std::numbers::pi));
}

TEST_CASE("estimates are 0 where all of a luminaire is below the horizon", "[luminaire]") {
    Draw draw(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 place = draw.point(10);
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, place, 1, draw));
        const LightBounds b = bounds(luminaire);
        const Vec3 normal = draw.direction();
        const Receiver point{b.centre + normal * b.radius * 1.001 + cross(normal, draw.point(3)),
                             normal};
        CHECK(unoccluded(luminaire, point) == 0);
    }
}

TEST_CASE("estimates grow with the radiance and not with the scale of the scene", "[luminaire]") {
    for (int i = 0; i < 500; ++i) {
        Draw draw(static_cast<std::uint64_t>(i)), again(static_cast<std::uint64_t>(i));
        const double scale = i % 2 ? 1e-3 : 1e3;
        const Vec3 place = draw.point(3), from = draw.point(3), normal = draw.direction();
        again.point();
        again.point();
        again.direction();
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, place, 1, draw), 1);
        const Luminaire larger =
            glowing(emitter(i % emitter_kinds, scale * place, scale, again), 7);
        CHECK(unoccluded(larger, {scale * from, normal}) ==
              Approx(7 * unoccluded(luminaire, {from, normal})).margin(1e-300));
    }
}

TEST_CASE("bounds hold every point that is sampled", "[luminaire]") {
    Draw draw(3);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 place = draw.point(10);
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, place, 1, draw));
        const LightBounds b = bounds(luminaire);
        const auto s =
            sample(luminaire, point_around(place, 1, draw), {draw.number(), draw.number()});
        if (s) CHECK(length(s->position - b.centre) <= b.radius * (1 + 1e-9));
        CHECK(b.intensity > 0);
        CHECK(b.luminance == Approx(1));
    }
}

TEST_CASE("what is drawn from a luminaire is met again with its density", "[luminaire][claim-1]") {
    Draw draw(21);
    std::array<int, emitter_kinds> drawn{}, missed{};
    for (int i = 0; i < 20000; ++i) {
        const Vec3 place = draw.point(3);
        const double size = std::pow(10, draw.between(-2, 1));
        const int kind = i % emitter_kinds;
        const Luminaire luminaire = glowing(emitter(kind, place, size, draw));
        const Receiver point{point_around(place, size, draw), draw.direction(),
                             lit_from(i % 5 == 0)};
        const auto s = sample(luminaire, point, {draw.number(), draw.number()});
        if (!s) continue;
        ++drawn[kind];
        LightHits met;
        intersect(luminaire, point, s->direction, met);
        bool found = false;
        for (const LightHit& m : met)
            found = found || (m.distance == Approx(s->distance).epsilon(1e-3) &&
                              m.density == Approx(s->density).epsilon(1e-2));
        missed[kind] += !found;
    }
    for (int kind = 0; kind < emitter_kinds; ++kind) {
        INFO(kind);
        CHECK(drawn[kind] > 500);
        CHECK(missed[kind] <= drawn[kind] / 100);  // at edges
    }
}

}  // namespace candelabra
