// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/aim.h"

#include "base/cosine_direction.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

TEST_CASE("aimed directions have the density that is stated, and arrive from far away",
          "[transport]") {
    const LitRegion region{.centre = Vec3(1, 2, 3), .radius = 2};
    Draw draw(6);
    const Vec3 normal(0, 1, 0);
    for (const double away : {1.0, 4.0, 300.0}) {
        const Vec3 from = region.centre + away * unit(Vec3(1, -1, 0.5));
        const Aim aim(region, from, 0.5);
        // The fractions of the light of a diffuse surface that go in some directions.
        double all = 0, beside = 0;
        int arrive = 0;
        constexpr int count = 200000;
        for (int i = 0; i < count; ++i) {
            const Vec3 direction = aim.draw({draw.number(), draw.number()}, [&](const Vec2& u) {
                return cosine_direction(normal, u);
            });
            CHECK(length(direction) == Approx(1));
            const double own = std::fmax(direction.y, 0) / std::numbers::pi;
            const double part = own / aim.density(direction, own) / count;
            all += part;
            if (direction.x > 0) beside += part;
            const Vec3 offset = region.centre - from;
            const double along = dot(offset, direction);
            arrive += along > 0 && length(offset - along * direction) < region.radius;
        }
        CAPTURE(away);
        CHECK(all == Approx(1).epsilon(0.01));
        CHECK(beside == Approx(0.5).epsilon(0.02));
        if (away > 2) CHECK(arrive > 0.4 * count);
    }
    const Aim within(region, region.centre, 0.5);
    CHECK(within.density(normal, 0.25) == 0.25);
}

}  // namespace candelabra
