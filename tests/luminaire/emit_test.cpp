// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/emit.h"

#include "base/random.h"
#include "luminaire/composite.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

/// Power of a luminaire of radiance 1, estimated by its own rays.
double emitted_power(const Luminaire& luminaire, std::uint32_t count, double inner = 0.5) {
    double sum = 0;
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        const auto drawn = emit(luminaire, inner,
                                {{uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)},
                                 {uniform(key, Purpose::bounce_u), uniform(key, Purpose::bounce_v)},
                                 uniform(key, Purpose::way_choice)});
        if (!drawn) continue;
        const double cosine = dot(drawn->ray.direction, drawn->normal);
        CHECK(cosine >= 0);
        CHECK(length(drawn->ray.direction) == Approx(1));
        sum += cosine / drawn->density;
    }
    return sum / count;
}

}  // namespace

TEST_CASE("rays that leave a luminaire carry its power", "[luminaire]") {
    Draw draw(4);
    for (int i = 0; i < 4 * emitter_kinds; ++i) {
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, draw.point(3), 1, draw));
        CAPTURE(i % emitter_kinds);
        const double found = emitted_power(luminaire, 20000);
        const double area = emitting_area(luminaire.emitter);
        CHECK(found == Approx(2 * std::numbers::pi * area).epsilon(0.02));
    }
}

TEST_CASE("rays leave every point of a luminaire on both sides, also where it hides itself",
          "[luminaire]") {
    // A room in a solid: the walls of the room are surfaces of the inner box.
    CompositeBuilder builder;
    const PartRef outer = builder.add({Cuboid{Vec3(-2), Vec3(2)}}),
                  room = builder.add(
                      {.shape = Cuboid{Vec3(-1), Vec3(1)}, .inverse = true, .turned = true});
    const auto solid =
        make_handle<Composite>(builder.finish(builder.add(Combination::common, {outer, room})));
    // Areas of 6 * 16 and of 6 * 4.
    for (const std::uint32_t leaf : {0u, 1u})
        for (const double inner : {0.5, 0.1}) {
            const Luminaire luminaire = glowing(composite_emitter(solid, leaf, false));
            const double area = leaf == 0 ? 96 : 24;
            CAPTURE(leaf, inner);
            CHECK(emitted_power(luminaire, 60000, inner) ==
                  Approx(2 * std::numbers::pi * area).epsilon(0.03));
        }
    const Luminaire ball = glowing(SphereEmitter{Vec3(1), 2});
    CHECK(emitted_power(ball, 20000, 1.0 / 16) ==
          Approx(32 * std::numbers::pi * std::numbers::pi).epsilon(0.02));
}

TEST_CASE("rays leave the surface itself", "[luminaire]") {
    Draw draw(5);
    for (int i = 0; i < 300; ++i) {
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, draw.point(3), 1, draw));
        const auto drawn =
            emit(luminaire, 0.5,
                 {{draw.number(), draw.number()}, {draw.number(), draw.number()}, draw.number()});
        if (!drawn) continue;
        const LightBounds b = bounds(luminaire);
        CHECK(length(drawn->ray.origin - b.centre) <= b.radius * (1 + 1e-6));
        // Seen from along the ray, the point is there, with some density.
        CHECK(density(luminaire, drawn->ray.at(3 * b.radius), -drawn->ray.direction) > 0);
    }
}

}  // namespace candelabra
