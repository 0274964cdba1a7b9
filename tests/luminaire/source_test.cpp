// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/source.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a light source gives pi times its luminance, by the cosine, at any distance",
          "[luminaire]") {
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const Luminaire source = glowing(SourceEmitter{draw.point(3), 1e-7, {}}, 2);
        const Vec3 centre = std::get<SourceEmitter>(source.emitter).centre;
        const Receiver point{draw.point(10), draw.direction()};
        const double cosine = dot(unit(centre - point.position), point.normal);
        CHECK(unoccluded(source, point) ==
              Approx(2 * std::numbers::pi * std::max(cosine, 0.0)).epsilon(1e-6).margin(1e-6));
        const auto drawn = sample(source, point, {0.5, 0.5});
        REQUIRE(drawn);
        CHECK(dot(drawn->direction, point.normal) == Approx(cosine));
    }
}

TEST_CASE("no ray meets a light source", "[luminaire]") {
    const Luminaire source = glowing(SourceEmitter{Vec3(0), 1, {}});
    LightHits met;
    intersect(source, {Vec3(0, 0, -5), Vec3(0, 0, 1)}, Vec3(0, 0, 1), met);
    CHECK(met.empty());
    CHECK(emitting_area(source.emitter) == 0);
}

}  // namespace candelabra
