// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/seen_share.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("light is worth little where trials did not see it, on that side", "[transport]") {
    Draw draw(1);
    std::vector<SeenShare::Trial> trials;
    for (int i = 0; i < 2000; ++i) {
        // A floor in a room, the ground outside, and the lower side of a roof over both.
        const Vec3 place(10 * draw.number() - 5, 0, draw.number());
        trials.push_back({place, Vec3(0, 1, 0), place.x < 0 ? 0.75 : 0});
        trials.push_back({place + Vec3(0, 1, 0), Vec3(0, -1, 0), 0.5});
    }
    const SeenShare share(trials);
    CHECK(share.at(Vec3(-3, 0, 0.5), Vec3(0, 1, 0)) == Approx(0.75).epsilon(0.01));
    CHECK(share.at(Vec3(3, 0, 0.5), Vec3(0, 1, 0)) < 0.01);
    CHECK(share.at(Vec3(3, 0, 0.5), Vec3(0, 1, 0)) > 0);
    CHECK(share.at(Vec3(3, 1, 0.5), unit(Vec3(0.1, -1, 0.2))) == Approx(0.5).epsilon(0.01));
    CHECK(share.at(Vec3(3, 1, 0.5), Vec3(1, 0, 0)) == 1);
    CHECK(SeenShare().at(Vec3(0), Vec3(1, 0, 0)) == 1);
}

TEST_CASE("trials in one place are one part", "[transport]") {
    const std::vector<SeenShare::Trial> trials(500, {Vec3(1), Vec3(1, 0, 0), 1});
    CHECK(SeenShare(trials).at(Vec3(2), Vec3(1, 0, 0)) == Approx(1));
}

}  // namespace candelabra
