// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/source_choices.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

/// Shadow rays to a source straight above, with a wall at that height.
double arriving_below_wall(double height) {
    const SourceChoices sources({{Vec3(0, 4, 0), 1e-6}});
    const auto wall = [&](const Ray&, double) -> std::optional<ProbeHit> {
        return ProbeHit{height, Vec3(0, -1, 0), 1e-9, {}, 0, 0};
    };
    return sources.arriving(0, {{Vec3(0), Vec3(0, 1, 0)}, 1e-9}, {}, wall);
}

}  // namespace

TEST_CASE("a light source gives pi times its luminance, by the cosine, at any distance",
          "[world]") {
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 centre = draw.point(3);
        const SourceChoices sources({{centre, 1e-7, {}, 2}});
        const Receiver point{draw.point(10), draw.direction()};
        const double cosine = dot(unit(centre - point.position), point.normal);
        CHECK(sources.unoccluded(0, point) ==
              Approx(2 * std::numbers::pi * std::max(cosine, 0.0)).epsilon(1e-6).margin(1e-6));
    }
}

TEST_CASE("light of a source arrives if no surface is before it", "[world]") {
    CHECK(arriving_below_wall(3) == 0);
    CHECK(arriving_below_wall(4) == Approx(std::numbers::pi));
    CHECK(arriving_below_wall(5) == Approx(std::numbers::pi));
}

TEST_CASE("no direction hits a light source", "[world]") {
    CHECK_FALSE(SourceChoices({{Vec3(0), 1}}).has_surface(0));
}

}  // namespace candelabra
