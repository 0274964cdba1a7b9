// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/triangle.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using std::numbers::pi;

TriangleEmitter random_triangle(Draw& draw) { return {draw.point(), draw.point(), draw.point()}; }

/// Irradiance summed over small parts of the area.
double quadrature(const TriangleEmitter& t, const Receiver& point, int steps) {
    const Vec3 e1 = t.corner2 - t.corner1, e2 = t.corner3 - t.corner1, scaled = cross(e1, e2);
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double root = std::sqrt((i + 0.5) / steps), v = (j + 0.5) / steps;
            const Vec3 offset = t.corner1 + root * ((1 - v) * e1 + v * e2) - point.position;
            const double d2 = dot(offset, offset), height = dot(offset, point.normal);
            if (height > 0 || point.horizon != Horizon::one_side)
                sum += std::abs(height * dot(offset, scaled)) / (2 * d2 * d2);
        }
    return sum / (steps * steps);
}

double solid_angle(const TriangleEmitter& t, const Vec3& from) {
    return 1 / density(t, from, unit((t.corner1 + t.corner2 + t.corner3) / 3.0 - from));
}

}  // namespace

TEST_CASE("a triangle's irradiance is what its parts add up to", "[luminaire]") {
    Draw draw(1);
    int cut = 0;
    for (int i = 0; i < 300; ++i) {
        const TriangleEmitter t = random_triangle(draw);
        Receiver point{draw.point(4), draw.direction(), lit_from(i % 3 == 0)};
        const double distance = length((t.corner1 + t.corner2 + t.corner3) / 3.0 - point.position);
        if (distance < 2) point.position = Vec3(2, 2, 2);
        const double low = std::fmin(dot(t.corner1 - point.position, point.normal),
                                     dot(t.corner2 - point.position, point.normal));
        const double high = std::fmax(dot(t.corner1 - point.position, point.normal),
                                      dot(t.corner2 - point.position, point.normal));
        cut += low < 0 && high > 0;
        const double expected = quadrature(t, point, 120);
        CHECK(unoccluded(t, 2, point) == Approx(2 * expected).epsilon(0.01).margin(1e-4));
    }
    CHECK(cut > 15);
}

TEST_CASE("a far triangle's irradiance keeps its digits", "[luminaire]") {
    const TriangleEmitter t{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    for (const double d : {1e2, 1e4, 1e6, 1e9}) {
        const Receiver point{Vec3(1.0 / 3, 1.0 / 3, -d), Vec3(0, 0, 1)};
        CHECK(unoccluded(t, 1, point) == Approx(0.5 / (d * d)).epsilon(1e-3));
    }
}

TEST_CASE("triangle samples are uniform in solid angle", "[luminaire][claim-22]") {
    Draw draw(2);
    for (int i = 0; i < 40; ++i) {
        const TriangleEmitter t = random_triangle(draw);
        const Vec3 from = (i % 2 ? 0.3 : 2.0) * draw.point();
        const Vec3 a = (t.corner2 + t.corner3) / 2.0, b = (t.corner3 + t.corner1) / 2.0,
                   c = (t.corner1 + t.corner2) / 2.0;
        const std::array<TriangleEmitter, 4> parts = {
            {{t.corner1, c, b}, {c, t.corner2, a}, {b, a, t.corner3}, {a, b, c}}};
        const double whole = solid_angle(t, from);
        if (whole < 0.02 || whole > 6) continue;
        constexpr int steps = 64;
        std::array<int, 4> counts{};
        for (int x = 0; x < steps; ++x)
            for (int y = 0; y < steps; ++y) {
                const auto s =
                    sample(t, from, {(x + draw.number()) / steps, (y + draw.number()) / steps});
                REQUIRE(s);
                CHECK(s->density == Approx(1 / whole));
                for (int p = 0; p < 4; ++p)
                    if (density(parts[p], from, s->direction) > 0) {
                        ++counts[p];
                        break;
                    }
            }
        for (int p = 0; p < 4; ++p) {
            const double part = solid_angle(parts[p], from);
            if (part < 1e-3 || part > 6) continue;
            // Stratified samples: only cells at the rim of a part are left to chance.
            CHECK(std::abs(counts[p] - steps * steps * part / whole) < 5 * std::sqrt(3.0 * steps));
        }
    }
}

TEST_CASE("a triangle's samples give its irradiance", "[luminaire]") {
    Draw draw(3);
    for (int i = 0; i < 60; ++i) {
        const TriangleEmitter t = random_triangle(draw);
        const Receiver point{(i % 3 ? 3.0 : 30.0) * draw.direction(), draw.direction(),
                             lit_from(i % 2 == 0)};
        const double found = sampled_irradiance(glowing(t), point, 100);
        CHECK(unoccluded(t, 1, point) == Approx(found).epsilon(0.01).margin(1e-5));
    }
}

TEST_CASE("a triangle overhead is seen with the variance that solid angle sampling has",
          "[luminaire]") {
    // A right triangle with legs of length 1, at height h above a floor point under its centroid.
    const TriangleEmitter t{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    for (const auto& [h, expected] :
         std::vector<std::pair<double, double>>{{0.1, 0.117}, {0.3, 0.026}, {1, 0.00143}}) {
        const Vec3 from(1.0 / 3, 1.0 / 3, -h);
        double sum = 0, square = 0;
        constexpr int steps = 200;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const auto s = sample(t, from, {(i + 0.5) / steps, (j + 0.5) / steps});
                const double y = s->direction.z / s->density;
                sum += y;
                square += y * y;
            }
        const double mean = sum / (steps * steps);
        CHECK(square / (steps * steps) / (mean * mean) - 1 == Approx(expected).epsilon(0.06));
    }
}

TEST_CASE("triangles of any shape, from anywhere, give finite samples with their density",
          "[luminaire]") {
    Draw draw(4);
    int given = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = draw.point(), along = draw.direction();
        const double flat = std::pow(10, draw.between(-12, 0)),
                     size = std::pow(10, draw.between(-9, 3));
        const TriangleEmitter t{size * a, size * (a + along),
                                size * (a + draw.number() * along + flat * draw.direction())};
        const double far = std::pow(10, draw.between(-9, 9));
        const Vec3 from = i % 7 == 0   ? t.corner1
                          : i % 7 == 1 ? 0.5 * (t.corner1 + t.corner3)
                                       : size * (a + far * draw.direction());
        const Receiver point{from, draw.direction(), lit_from(i % 2 == 0)};
        const double estimate = unoccluded(t, 1, point);
        CHECK(std::isfinite(estimate));
        CHECK(estimate >= 0);
        CHECK(estimate < 2 * pi * 1.01);
        const auto s = sample(t, from, {draw.number(), draw.number()});
        if (!s) continue;
        ++given;
        CHECK(std::isfinite(s->density));
        CHECK(s->density > 0);
        CHECK(length(s->direction) == Approx(1));
        CHECK(length(from + s->distance * s->direction - s->position) <=
              1e-12 * (length(from) + s->distance));
        if (dot(s->direction, point.normal) > 1e-9) CHECK(estimate > 0);
    }
    CHECK(given > 15000);
}

TEST_CASE("a triangle's density agrees with its samples and is 0 beside it", "[luminaire]") {
    Draw draw(5);
    for (int i = 0; i < 2000; ++i) {
        const TriangleEmitter t = random_triangle(draw);
        const Vec3 from = std::pow(10, draw.between(-1, 4)) * draw.direction();
        const auto s = sample(t, from, {draw.between(0.05, 0.95), draw.between(0.05, 0.95)});
        REQUIRE(s);
        CHECK(density(t, from, s->direction) == Approx(s->density).epsilon(1e-6));
        CHECK(density(t, from, -s->direction) == 0);
    }
}

}  // namespace candelabra
