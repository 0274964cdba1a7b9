// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/brightness.h"

#include "luminaire/composite.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// One in a hundred squares of a raster of 40 x 40 is bright, the others glow a little.
double sparse(double x, double y) {
    const auto i = static_cast<int>(std::floor(40 * x)), j = static_cast<int>(std::floor(40 * y));
    return (i * 7 + j * 13) % 100 == 0 ? 100 : 0.01;
}

const auto pattern = [](const Vec3& p) {
    return sparse(0.5 + p.x / 4, 0.5 + (p.y + 0.7 * p.z) / 4);
};

Luminaire lamp(const Emitter& emitter, bool mapped) {
    Luminaire result = glowing(emitter, 100);
    result.varying = true;
    if (mapped) result.brightness = brightness_of(result, 80, pattern);
    return result;
}

struct LampMoments {
    double mean = 0, relative_variance = 0;
};
/// Moments of the light that samples bring to a point.
LampMoments moments(const Luminaire& luminaire, const Receiver& point, int steps,
                    FunctionRef<double(const Vec3&)> glow = pattern) {
    double sum = 0, squares = 0;
    Draw draw(5);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const auto s = sample(luminaire, point,
                                  {(i + draw.number()) / steps, (j + draw.number()) / steps});
            if (!s) continue;
            const double light = glow(s->position) *
                                 std::fmax(dot(s->direction, point.normal), 0) / s->density;
            sum += light;
            squares += light * light;
        }
    const double count = steps * steps, mean = sum / count;
    return {mean, squares / count / (mean * mean) - 1};
}

const std::vector<Emitter>& flat_emitters() {
    static const std::vector<Emitter> all = {
        TriangleEmitter{Vec3(-2, -1, 0), Vec3(2, -1, 0), Vec3(-1, 1.5, 0.2)},
        AreaEmitter{Cuboid{Vec3(-2, -1, -0.1), Vec3(2, 1, 0.1)}, {}},
        AreaEmitter{
            Cuboid{Vec3(-1), Vec3(1)},
            make_handle<Transform>(
                Transform::scaling({1.5, 0.8, -0.5}).then(Transform::rotation({10, 40, 20})))},
        AreaEmitter{Disc{Vec3(0), Vec3(0, 0.2, 1), 1.5, 0.4}, {}}};
    return all;
}

std::vector<Emitter> mapped_emitters() {
    std::vector<Emitter> all = flat_emitters();
    all.push_back(SphereEmitter{Vec3(0.2, 0, 0.1), 1.8});
    return all;
}

}  // namespace

TEST_CASE("a screen with few bright spots makes little noise, and the same light",
          "[luminaire][claim-26]") {
    for (const Emitter& emitter : flat_emitters())
        for (const Vec3& place : {Vec3(0.5, 0.3, -4), Vec3(-6, 3, 5), Vec3(0.4, -3, -0.7)}) {
            const Receiver point{place, unit(Vec3(0.1, 0.2, 0) - place)};
            const LampMoments even = moments(lamp(emitter, false), point, 2000),
                              mapped = moments(lamp(emitter, true), point, 700);
            CAPTURE(emitter.index(), place.x, even.relative_variance, mapped.relative_variance);
            CHECK(mapped.mean == Approx(even.mean).epsilon(0.02));
            CHECK(even.relative_variance > 20 * mapped.relative_variance);
        }
}

TEST_CASE("a globe with few bright spots makes little noise, and the same light, also inside it",
          "[luminaire][claim-26]") {
    const auto glow = [](const Vec3& p) {
        return std::sin(9 * p.x) * std::sin(9 * p.y + 1) * std::sin(9 * p.z) > 0.7 ? 100 : 0.01;
    };
    const SphereEmitter globe{Vec3(0.3, -0.2, 0.1), 2};
    Luminaire known = glowing(globe, 100);
    known.brightness = brightness_of(known, 128, glow);
    REQUIRE(known.brightness);
    // A point that nearly touches the globe sees so little of it that the map may gain nothing.
    const std::vector<std::pair<Vec3, double>> places = {
        {Vec3(0.5, 0.3, -4), 8},    {Vec3(-60, 30, 50), 8},    {Vec3(0.4, -2.4, -0.7), 2.5},
        {Vec3(0.4, -2.22, 0.1), 0}, {Vec3(0.8, 0.5, -0.7), 5}, {Vec3(1.5, 0.9, -0.8), 5}};
    for (const auto& [place, gain] : places) {
        const Receiver point{place, unit(globe.centre + Vec3(0.1, 0.2, 0) - place)};
        const LampMoments even = moments(glowing(globe, 100), point, 2000, glow),
                          mapped = moments(known, point, 700, glow);
        CAPTURE(place.x, place.y, even.relative_variance, mapped.relative_variance);
        CHECK(mapped.mean == Approx(even.mean).epsilon(0.02));
        CHECK(even.relative_variance >= gain * mapped.relative_variance - 1e-9);
    }
}

TEST_CASE("a globe that glows nearly evenly keeps its formula", "[luminaire]") {
    const auto glow = [](const Vec3& p) { return 2 + std::sin(9 * p.x); };
    CHECK_FALSE(brightness_of(glowing(SphereEmitter{Vec3(0), 2}, 3), 128, glow));
}

TEST_CASE("a curved lamp with few bright spots makes less noise, and the same light",
          "[luminaire][claim-26]") {
    const auto spots = [](const Vec3& p) { return std::cos(9 * p.x) * std::cos(9 * p.y) > 0.9; };
    const auto glow = [&](const Vec3& p) { return spots(p) ? 100 : 0.01; };
    // Much of a torus is hidden behind itself from everywhere, bright or not.
    const std::vector<std::pair<BuiltShape, double>> shapes = {
        {built(Sphere{Vec3(0), 1}), 4},
        {built(Cylinder{Vec3(-1, 0, 0), Vec3(1, 0.3, 0), 0.6, false}), 4},
        {built(Cone{Vec3(0, -1, 0), 1, Vec3(0, 1, 0), 0.3, false}), 3},
        {built(Torus{1, 0.4}), 1.3}};
    for (const auto& [shape, gain] : shapes) {
        CompositeBuilder builder;
        const PartRef part = builder.add({shape, {}});
        const auto whole = make_handle<Composite>(builder.finish(part));
        const Luminaire known = glowing(bright_composite_emitter(whole, part.index, glow), 100),
                        unknown = glowing(composite_emitter(whole, part.index), 100);
        CHECK(std::get<CompositeEmitter>(known.emitter).unevenness > 10);
        CHECK(bounds(known).intensity < 0.1 * bounds(unknown).intensity);
        for (const Vec3& place : {Vec3(0.5, 0.3, -4), Vec3(-6, 3, 5)}) {
            const Receiver point{place, unit(Vec3(0.1, 0.2, 0) - place)};
            const LampMoments even = moments(unknown, point, 1000, glow),
                              mapped = moments(known, point, 500, glow);
            CAPTURE(shape.index(), place.x, even.relative_variance, mapped.relative_variance);
            CHECK(mapped.mean == Approx(even.mean).epsilon(0.03));
            CHECK(even.relative_variance > gain * mapped.relative_variance);
        }
    }
}

TEST_CASE("points of a screen are met again with the density that they were drawn with",
          "[luminaire]") {
    Draw draw(1);
    for (const Emitter& emitter : mapped_emitters()) {
        const Luminaire luminaire = lamp(emitter, true);
        for (int i = 0; i < 2000; ++i) {
            const Receiver point{5.0 * draw.point(), draw.direction()};
            const auto s = sample(luminaire, point, {draw.number(), draw.number()});
            if (!s) continue;
            LightHits met;
            intersect(luminaire, point, s->direction, met);
            REQUIRE(!met.empty());
            double nearest = INFINITY, density = 0;
            for (const LightHit& m : met)
                if (std::abs(m.distance - s->distance) < nearest) {
                    nearest = std::abs(m.distance - s->distance);
                    density = m.density;
                }
            CHECK(nearest < 1e-6 * s->distance);
            CHECK(density == Approx(s->density).epsilon(1e-4));
            CHECK(length(point.position + s->distance * s->direction - s->position) < 1e-9);
        }
    }
}

TEST_CASE("a screen counts by its mean, and a dark one by something", "[luminaire]") {
    const Emitter screen = AreaEmitter{Disc{Vec3(0), Vec3(0, 0, 1), 1, 0}, {}};
    Luminaire half = glowing(screen, 8);
    half.brightness = brightness_of(half, 64, [](const Vec3& p) { return p.x > 0 ? 8.0 : 0.0; });
    CHECK(bounds(half).intensity ==
          Approx(0.5 * bounds(glowing(screen, 8)).intensity).epsilon(0.01));
    Luminaire dark = glowing(screen, 8);
    dark.brightness = brightness_of(dark, 16, [](const Vec3&) { return 0.0; });
    CHECK(bounds(dark).intensity > 0);
    const Receiver point{Vec3(0.3, 0.2, 2), Vec3(0, 0, -1)};
    CHECK(unoccluded(dark, point) > 0);
    CHECK(sample(dark, point, {0.3, 0.7})->density ==
          Approx(sample(glowing(screen, 8), point, {0.3, 0.7})->density));
}

}  // namespace candelabra
