// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/composite.h"

#include "luminaire/sphere.h"
#include "support/axes.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

CompositeEmitter alone(const BuiltShape& shape) {
    CompositeBuilder builder;
    const PartRef leaf = builder.add({shape});
    return composite_emitter(make_handle<Composite>(builder.finish(leaf)), leaf.index);
}

/// Mean and relative variance of the draws.
struct Drawn {
    double mean = 0, variance = 0;
};
Drawn drawn_irradiance(const Luminaire& light, const Receiver& point, int count, Draw& draw) {
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
        const auto s = sample(light, point.position, {draw.number(), draw.number()});
        const double given = s ? std::fmax(0, dot(s->direction, point.normal)) / s->density : 0;
        sum += given / count;
        squares += given * given / count;
    }
    return {sum, squares / (sum * sum) - 1};
}

CompositeEmitter half_ball() {
    CompositeBuilder builder;
    const PartRef ball = builder.add({Sphere{o, 1}}), cut = builder.add({Plane{x, 0}});
    const PartRef both = builder.add(Combination::common, {ball, cut});
    return composite_emitter(make_handle<Composite>(builder.finish(both)), ball.index);
}

}  // namespace

TEST_CASE("any shape gives the light that it would give as an emitter of its own", "[luminaire]") {
    const Luminaire ball = glowing(SphereEmitter{o, 1}), any = glowing(alone(Sphere{o, 1}));
    REQUIRE(std::get<CompositeEmitter>(any.emitter).proxy);
    Draw draw(1);
    for (int i = 0; i < 20; ++i) {
        const Receiver point{draw.between(1.1, 5) * draw.direction(), draw.direction()};
        const double expected = sampled_irradiance(ball, point, 100);
        CHECK(drawn_irradiance(any, point, 250'000, draw).mean ==
              Approx(expected).epsilon(0.02).margin(0.002));
        if (expected > 1e-6) CHECK(unoccluded(any, point) > 0);
    }
}

TEST_CASE("samples of a composite lie on the leaf, with the density that they say", "[luminaire]") {
    const CompositeEmitter e = half_ball();
    Draw draw(2);
    std::size_t met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from = point_around(o, 1, draw);
        const auto s = sample(e, from, {draw.number(), draw.number()});
        if (!s) continue;
        ++met;
        CHECK(length(s->position) == Approx(1).epsilon(1e-6));
        CHECK(s->position.x < 1e-9);
        CHECK(length(from + s->distance * s->direction - s->position) < 1e-9 * (1 + s->distance));
        CHECK(density(e, from, s->direction) == Approx(s->density));
    }
    CHECK(met > 500);
    CHECK(density(e, 5.0 * x, x) == 0);
}

TEST_CASE("its size is that of its shadow", "[luminaire]") {
    // A coarse estimate, which is good enough to compare luminaires.
    CHECK(alone(Sphere{o, 2}).seen_area == Approx(4 * 3.14159).epsilon(0.15));
    CHECK(alone(Cuboid{o, Vec3(1)}).seen_area == Approx(1.5).epsilon(0.15));
    CHECK(alone(Torus{1, 0.3}).seen_area > 0);
    CHECK(emitting_area(alone(Sphere{o, 1})) == Approx(4 * 3.14159).epsilon(0.15));
    const LightBounds b = bounds(half_ball(), 3);
    CHECK(b.luminance == 3);
    CHECK(b.box.high.x < 1e-9);
    CHECK(b.radius >= 1);
}

TEST_CASE("a proxy mesh makes less noise and the same light", "[luminaire]") {
    // A thin ring fills a small part of any cone around it.
    CompositeBuilder builder;
    const PartRef ring = builder.add({Torus{1, 0.05}});
    const auto composite = make_handle<Composite>(builder.finish(ring));
    const Luminaire with_proxy = glowing(composite_emitter(composite, ring.index)),
                    searched = glowing(composite_emitter(composite, ring.index, false));
    REQUIRE(std::get<CompositeEmitter>(with_proxy.emitter).proxy);
    Draw draw(3);
    for (int i = 0; i < 5; ++i) {
        const Vec3 position = draw.between(1.5, 4) * draw.direction();
        const Receiver point{position, unit(-position)};
        const Drawn by_proxy = drawn_irradiance(with_proxy, point, 40'000, draw),
                    by_search = drawn_irradiance(searched, point, 400'000, draw);
        CHECK(by_proxy.mean == Approx(by_search.mean).epsilon(0.03));
        CHECK(by_proxy.variance < 0.4 * by_search.variance);
    }
}

}  // namespace candelabra
