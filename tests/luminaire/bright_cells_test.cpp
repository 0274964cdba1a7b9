// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/bright_cells.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A triangle with one bright half.
const auto glow = [](const Vec2& at) -> std::optional<double> {
    if (at.x + at.y > 1) return {};
    return at.x < 0.5 && at.y < 0.5 ? 3.0 : 1.0;
};

}  // namespace

TEST_CASE("means are over the whole square", "[luminaire]") {
    const BrightCells cells(64, 64, glow);
    CHECK(cells.covered() == Approx(0.5).epsilon(0.02));
    CHECK(cells.mean() == Approx(0.25 * 3 + 0.25).epsilon(0.02));
    CHECK(cells.mean_square() == Approx(0.25 * 9 + 0.25).epsilon(0.02));
}

TEST_CASE("points are drawn with the density that they say, which is that of their brightness",
          "[luminaire]") {
    const BrightCells cells(64, 32, glow);
    Draw draw(3);
    int bright = 0;
    double inverse = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const BrightCells::Drawn drawn = cells.draw({draw.number(), draw.number()});
        CHECK(drawn.density == Approx(cells.density(drawn.at)));
        bright += drawn.at.x < 0.5 && drawn.at.y < 0.5;
        inverse += (drawn.at.x + drawn.at.y < 1) / drawn.density;
    }
    CHECK(bright == Approx(0.75 * count).epsilon(0.03));
    CHECK(inverse == Approx(0.5 * count).epsilon(0.03));
}

TEST_CASE("what neither glows nor is beside what does is never drawn", "[luminaire]") {
    const BrightCells cells(10, 10, [](const Vec2& at) { return at.x < 0.5 ? 1.0 : 0.0; });
    CHECK(cells.density({0.25, 0.5}) > 1.8);
    CHECK(cells.density({0.55, 0.5}) > 0);
    CHECK(cells.density({0.75, 0.5}) == 0);
}

}  // namespace candelabra
