// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/start_guide.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("starts are drawn where trials were worth most, with the density that is stated",
          "[transport]") {
    StartTrials trials;
    for (std::size_t i = 0; i < StartTrials::cells; ++i) {
        const Vec2 place = StartTrials::place(i, {0.5, 0.5});
        trials.add(i, place.x > 0.75 && place.y > 0.75 ? 3 : 0);
    }
    CHECK(trials.sum() == 3 * StartTrials::cells / 16);
    const StartGuide guide(trials), even{StartGuide()};
    Draw draw(1);
    double area = 0, corner = 0, mean_x = 0;
    constexpr int count = 100000;
    int in_corner = 0;
    for (int i = 0; i < count; ++i) {
        const Vec2 u{draw.number(), draw.number()};
        const StartGuide::Drawn drawn = guide.draw(u);
        CHECK((drawn.place.x >= 0 && drawn.place.x < 1 && drawn.place.y >= 0 && drawn.place.y < 1));
        const bool inside = drawn.place.x >= 0.75 && drawn.place.y >= 0.75;
        in_corner += inside;
        area += drawn.factor / count;
        mean_x += drawn.factor * drawn.place.x / count;
        if (inside) corner += drawn.factor / count;
        CHECK(even.draw(u).place == u);
        CHECK(even.draw(u).factor == 1);
    }
    CHECK(area == Approx(1).epsilon(0.01));
    CHECK(mean_x == Approx(0.5).epsilon(0.01));
    CHECK(corner == Approx(1.0 / 16).epsilon(0.02));
    CHECK(in_corner > 0.5 * count);
}

TEST_CASE("trials that were worth nothing leave all starts alike", "[transport]") {
    const StartGuide guide{StartTrials()};
    CHECK(guide.draw({0.3, 0.7}).place == Vec2(0.3, 0.7));
    CHECK(guide.draw({0.3, 0.7}).factor == 1);
}

}  // namespace candelabra
