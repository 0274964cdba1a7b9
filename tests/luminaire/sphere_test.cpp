// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/sphere.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

/// A point below a unit sphere that fills a cone of half angle sigma, at the zenith angle t.
struct Seen {
    SphereEmitter sphere{Vec3(0), 1};
    Receiver point;
    Seen(double sigma, double t) {
        point.position = Vec3(0, 0, -1 / std::sin(sigma));
        point.normal = Vec3(std::sin(t), 0, std::cos(t));
    }
};

struct SphereMoments {
    double mean, relative_variance;
};

SphereMoments moments(const SphereEmitter& sphere, const Receiver& point, int steps) {
    double sum = 0, square = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const auto s = sample(sphere, point.position, {(i + 0.5) / steps, (j + 0.5) / steps});
            const double y = s ? std::fmax(0, dot(s->direction, point.normal)) / s->density : 0;
            sum += y;
            square += y * y;
        }
    const double count = steps * steps, mean = sum / count;
    return {mean, square / count / (mean * mean) - 1};
}

}  // namespace

TEST_CASE("a sphere's cone has the variance that the closed form says", "[luminaire][claim-3]") {
    // Relative variance of the cosine over a cone for a diffuse receiver, as in the paper's Figure
    // 2.
    const std::vector<std::array<double, 3>> rows = {
        {5, 0, 1.2e-6}, {5, 45, .0019}, {5, 75, .027},  {15, 0, .0001}, {15, 30, .0059},
        {15, 75, .243}, {30, 0, .0017}, {30, 30, .026}, {30, 45, .075}, {30, 60, .222},
        {45, 0, .0098}, {45, 30, .070}, {60, 0, .037},  {60, 30, .16}};
    for (const auto& [sigma, t, table] : rows) {
        const double c = std::cos(sigma * degree), z = std::cos(t * degree),
                     m2 = (1 + c + c * c) / 3;
        const double closed =
            (z * z * m2 + (1 - z * z) * (1 - m2) / 2) / (z * z * (1 + c) * (1 + c) / 4) - 1;
        INFO(sigma << " " << t);
        CHECK(closed == Approx(table).epsilon(0.3));  // the table is rounded to one or two digits
        const Seen seen(sigma * degree, t * degree);
        const SphereMoments found = moments(seen.sphere, seen.point, 400);
        CHECK(found.relative_variance == Approx(closed).epsilon(0.05).margin(1e-7));
        CHECK(found.mean == Approx(pi * std::pow(std::sin(sigma * degree), 2) * z).epsilon(1e-4));
    }
}

TEST_CASE("a sphere's irradiance is exact above the horizon", "[luminaire]") {
    for (const double sigma : {1e-6, 1.0, 20.0, 40.0})
        for (const double t : {0.0, 10.0, 45.0}) {
            const Seen seen(sigma * degree, t * degree);
            CHECK(unoccluded(seen.sphere, 3, seen.point) ==
                  Approx(3 * pi * std::pow(std::sin(sigma * degree), 2) * std::cos(t * degree))
                      .epsilon(1e-9));
        }
}

TEST_CASE("a sphere's irradiance falls to 0 exactly where all of it is below the horizon",
          "[luminaire]") {
    const double sigma = 30 * degree;
    double last = unoccluded(SphereEmitter{Vec3(0), 1}, 1, Seen(sigma, 60 * degree).point);
    for (double t = 61; t < 120; ++t) {
        const double now = unoccluded(SphereEmitter{Vec3(0), 1}, 1, Seen(sigma, t * degree).point);
        INFO(t);
        CHECK(now > 0);
        CHECK(now < last);
        last = now;
    }
    CHECK(unoccluded(SphereEmitter{Vec3(0), 1}, 1, Seen(sigma, 120.0001 * degree).point) == 0);
    CHECK(unoccluded(SphereEmitter{Vec3(0), 1}, 1, Seen(sigma, 119.9999 * degree).point) > 0);
}

TEST_CASE("a sphere cut by the horizon is estimated to within a quarter", "[luminaire]") {
    for (const double sigma : {10.0, 30.0, 60.0})
        for (double t = 90 - sigma; t < 85 + sigma; t += 5) {
            const Seen seen(sigma * degree, t * degree);
            INFO(sigma << " " << t);
            const double exact = sampled_irradiance(glowing(seen.sphere), seen.point, 300);
            const double estimate = unoccluded(seen.sphere, 1, seen.point);
            CHECK(std::abs(estimate - exact) <
                  0.25 * exact + 0.02 * pi * std::pow(std::sin(sigma * degree), 2));
        }
}

TEST_CASE("a surface that is lit on both sides gets what both get", "[luminaire]") {
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const SphereEmitter sphere{draw.point(), draw.between(0.01, 1)};
        Receiver front{draw.point(3), draw.direction()}, back = front, both = front;
        back.normal = -front.normal;
        both.horizon = Horizon::both_sides;
        CHECK(unoccluded(sphere, 1, both) ==
              Approx(unoccluded(sphere, 1, front) + unoccluded(sphere, 1, back)));
    }
}

TEST_CASE("inside a glowing sphere the irradiance is pi times the radiance", "[luminaire]") {
    Draw draw(2);
    for (int i = 0; i < 20; ++i) {
        const Receiver point{0.95 * draw.number() * draw.direction(), draw.direction()};
        CHECK(unoccluded(SphereEmitter{Vec3(0), 1}, 1, point) == Approx(pi));
        CHECK(sampled_irradiance(glowing(SphereEmitter{Vec3(0), 1}), point, 400) ==
              Approx(pi).epsilon(0.01));
    }
}

TEST_CASE("a sphere's density integrates to 1", "[luminaire]") {
    const SphereEmitter sphere{Vec3(1, 2, 3), 2};
    for (const Vec3& from :
         {Vec3(1, 2, 3), Vec3(1, 2, 4.5), Vec3(2, 3, 4), Vec3(1, 2, 5.5), Vec3(5, 5, 5)}) {
        double sum = 0;
        constexpr int steps = 400;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const double z = -1 + 2 * (i + 0.5) / steps, r = std::sqrt(1 - z * z),
                             angle = 2 * pi * (j + 0.5) / steps;
                sum += density(sphere, from, {r * std::cos(angle), r * std::sin(angle), z});
            }
        CHECK(sum * 4 * pi / (steps * steps) == Approx(1).epsilon(0.01));
    }
}

TEST_CASE("sphere samples lie on the sphere, near side, with their density, at any distance",
          "[luminaire]") {
    Draw draw(3);
    for (const double gap : {1e-6, 1e-3, 0.5, 3.0, 1e3, 1e6, 1e9})
        for (const double radius : {1e-6, 1.0, 1e6})
            for (int i = 0; i < 50; ++i) {
                const SphereEmitter sphere{radius * draw.point(), radius};
                const Vec3 from = sphere.centre + radius * (1 + gap) * draw.direction();
                const auto s = sample(sphere, from, {0.999 * draw.number(), draw.number()});
                INFO(gap << " " << radius);
                REQUIRE(s);
                CHECK(length(s->direction) == Approx(1).epsilon(1e-14));
                CHECK(std::abs(length(s->position - sphere.centre) - radius) <
                      radius * 1e-9 + 1e-15 * length(from));
                CHECK(length(from + s->distance * s->direction - s->position) <
                      radius * (1e-7 + 1e-14 * gap));
                CHECK(dot(s->position - sphere.centre, s->direction) < radius * 1e-6);
                CHECK(s->density > 0);
                CHECK(std::isfinite(s->density));
                CHECK(density(sphere, from, s->direction) == Approx(s->density));
            }
}

TEST_CASE("a point on a glowing sphere gets no light from it, and one in its middle can be asked",
          "[luminaire]") {
    Draw draw(4);
    for (int i = 0; i < 200; ++i) {
        const SphereEmitter sphere{draw.point(100), 0.01};
        const Vec3 normal = draw.direction(), from = sphere.centre + sphere.radius * normal;
        CHECK(unoccluded(sphere, 1, {from, normal}) < 1e-6);
        CHECK(unoccluded(sphere, 1, {from, -normal}) == Approx(pi).epsilon(1e-4));
        const auto s = sample(sphere, from, {draw.number(), draw.number()});
        if (s) CHECK(dot(s->direction, normal) < 1e-3);
        const auto middle = sample(sphere, sphere.centre, {draw.number(), draw.number()});
        REQUIRE(middle);
        CHECK(middle->density == Approx(1 / (4 * pi)));
    }
}

TEST_CASE("a sphere above the horizon lights a diffuse surface without any noise",
          "[luminaire][claim-7]") {
    // The paper's Figure 2 with projected solid angle: every sample is the irradiance itself.
    Draw draw(11);
    int projected = 0;
    for (int i = 0; i < 20000; ++i) {
        const SphereEmitter sphere{draw.point(3), std::pow(10, draw.between(-4, 1))};
        const Receiver point{point_around(sphere.centre, 2 * sphere.radius, draw), draw.direction(),
                             lit_from(i % 3 == 0)};
        const Vec3 offset = sphere.centre - point.position;
        const double sine = sphere.radius / length(offset);
        const double height = dot(unit(offset), point.normal);
        if (!(sine < 0.999) || !(height > 1.001 * sine)) continue;
        const auto s = sample(sphere, point, {draw.number(), draw.number()});
        REQUIRE(s);
        ++projected;
        const double cosine = dot(s->direction, point.normal);
        CHECK(cosine / s->density == Approx(pi * sine * sine * height).epsilon(1e-6));
        CHECK(length(s->direction) == Approx(1));
        CHECK(length(s->position - sphere.centre) == Approx(sphere.radius));
        // The point is on the near side.
        CHECK(dot(s->position - sphere.centre, s->direction) <= 1e-6 * sphere.radius);
    }
    CHECK(projected > 3000);
}

TEST_CASE("points of a sphere are met again with the density that they were drawn with",
          "[luminaire]") {
    Draw draw(12);
    int drawn = 0, missed = 0;
    for (int i = 0; i < 20000; ++i) {
        const SphereEmitter sphere{draw.point(3), std::pow(10, draw.between(-3, 1))};
        const Receiver point{point_around(sphere.centre, 2 * sphere.radius, draw), draw.direction(),
                             lit_from(i % 3 == 0)};
        const auto s = sample(sphere, point, {draw.number(), draw.number()});
        if (!s) continue;
        ++drawn;
        LightHits met;
        intersect(sphere, point, s->direction, met);
        bool found = false;
        for (const LightHit& m : met)
            found = found || (m.distance == Approx(s->distance).epsilon(1e-3) &&
                              m.density == Approx(s->density).epsilon(1e-3));
        missed += !found;
    }
    CHECK(drawn > 15000);
    CHECK(missed < drawn / 500);  // at the rim
}

}  // namespace candelabra
