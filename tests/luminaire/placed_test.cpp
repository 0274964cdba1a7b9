// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/placed.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A similarity, which is a reflection in every second call.
Transform similarity(Draw& draw, bool mirrored) {
    const double scale = draw.between(0.2, 5);
    return Transform::scaling({mirrored ? -scale : scale, scale, scale})
        .then(Transform::rotation(draw.point(180)))
        .then(Transform::translation(draw.point(10)));
}

}  // namespace

TEST_CASE("a placed luminaire is the luminaire in its place", "[luminaire]") {
    Draw draw(5);
    int met = 0;
    for (int i = 0; i < 40 * emitter_kinds; ++i) {
        const Luminaire own = glowing(emitter(i % emitter_kinds, draw.point(2), 0.7, draw));
        REQUIRE(can_be_placed(own));
        const Transform place = similarity(draw, i % 2 == 1);
        const double scale = place.uniform_scale();
        const Luminaire there = placed(own, place);
        CHECK(emitting_area(there.emitter) ==
              Approx(scale * scale * emitting_area(own.emitter)).epsilon(1e-9));
        const LightBounds before = bounds(own), after = bounds(there);
        CHECK(after.intensity == Approx(scale * scale * before.intensity).epsilon(1e-9));
        CHECK(after.luminance == before.luminance);
        for (int k = 0; k < 20; ++k) {
            const Vec3 from = draw.point(5), normal = draw.direction();
            const Receiver here{from, normal};
            const Receiver moved{place.point(from), unit(place.direction(normal))};
            const auto drawn = sample(own, here, {draw.number(), draw.number()});
            if (!drawn) continue;
            LightHits hits, hits_there;
            intersect(own, here, drawn->direction, hits);
            intersect(there, moved, unit(place.direction(drawn->direction)), hits_there);
            REQUIRE(hits.size() == hits_there.size());
            for (std::size_t n = 0; n < hits.size(); ++n) {
                ++met;
                CHECK(hits_there[n].distance == Approx(scale * hits[n].distance).epsilon(1e-6));
                CHECK(hits_there[n].density == Approx(hits[n].density).epsilon(1e-4));
            }
        }
    }
    CHECK(met > 1000);
}

TEST_CASE("the sealed side of a triangle stays on its side in a reflection", "[luminaire]") {
    const Luminaire face =
        glowing(TriangleEmitter{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), SealedSide::inner});
    const Transform mirror = Transform::scaling({1, 1, -1}), turn = Transform::rotation({30, 0, 0});
    const auto side = [&](const Transform& place) {
        return std::get<TriangleEmitter>(placed(face, place).emitter).sealed;
    };
    CHECK(side(turn) == SealedSide::inner);
    CHECK(side(mirror) == SealedSide::outer);
    CHECK(side(mirror.then(turn).then(mirror)) == SealedSide::inner);
}

TEST_CASE("luminaires that are not alike everywhere cannot be placed", "[luminaire]") {
    Luminaire lamp = glowing(SphereEmitter{Vec3(0), 1});
    CHECK(can_be_placed(lamp));
    lamp.varying = true;
    CHECK_FALSE(can_be_placed(lamp));
}

}  // namespace candelabra
