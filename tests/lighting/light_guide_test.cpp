// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_guide.h"

#include "support/ball_over_floor.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const LightBall ball{Vec3(0), 1.2};

LightGuide outlook_of(const Box& cell) {
    return LightGuide(cell, ball, survey_places_in(cell, {}, ball_over_floor), ball_over_floor,
                      nullptr);
}

}  // namespace

TEST_CASE("directions of an outlook have the density that is stated for them", "[lighting]") {
    // Near the ball the outlook covers the whole sphere, farther away only the ball.
    for (const Box& cell :
         {Box{Vec3(0.5, -2, 0.5), Vec3(1, -1, 1)}, Box{Vec3(4, -2, 4), Vec3(5, -1, 5)}}) {
        const LightGuide outlook = outlook_of(cell);
        Draw draw(3);
        for (int i = 0; i < 20; ++i) {
            Vec3 position = cell.low + Vec3(draw.number(), 0, draw.number()) * cell.size();
            position.y = -1.5;
            const Receiver point{position, i % 4 ? Vec3(0, 1, 0) : draw.direction(),
                                 lit_from(i % 3 == 0)};
            LightGuide::Weights weights;
            outlook.weigh(point, weights);
            if (!(weights.total > 0)) continue;
            double all = 0;
            constexpr int steps = 64;
            for (int a = 0; a < steps; ++a)
                for (int b = 0; b < steps; ++b) {
                    const auto drawn =
                        LightGuide::draw(weights, {(a + 0.5) / steps, (b + 0.5) / steps});
                    CHECK(length(drawn.direction) == Approx(1));
                    CHECK(LightGuide::density(weights, drawn.direction) ==
                          Approx(drawn.density).epsilon(1e-6));
                    all += 1 / drawn.density / (steps * steps);
                }
            // The mean of 1 / density is the solid angle of the bins that can be sampled.
            CHECK(all <= 4 * 3.1416);
            CHECK(all > 0.2 / weights.cone.bin_density());
        }
    }
}

TEST_CASE("an outlook draws what shines more often than chance", "[lighting]") {
    const Box cell{Vec3(3, -2, 3), Vec3(3.5, -1, 3.5)};
    const LightGuide outlook = outlook_of(cell);
    CHECK(outlook.noise() < 2);
    const Receiver point{Vec3(3.2, -1.5, 3.2), Vec3(0, 1, 0)};
    LightGuide::Weights weights;
    outlook.weigh(point, weights);
    int met = 0;
    Draw draw(4);
    for (int i = 0; i < 1000; ++i) {
        const auto drawn = LightGuide::draw(weights, {draw.number(), draw.number()});
        const auto seen = ball_over_floor({point.position, drawn.direction}, 1e-9);
        met += seen && seen->light;
    }
    CHECK(met > 500);
}

TEST_CASE("an outlook tells what scattered rays would see", "[lighting]") {
    const Box cell{Vec3(-1, -2, -1), Vec3(1, -1, 1)};
    const auto even = [](const Ray& ray, double) -> std::optional<ProbeHit> {
        return ProbeHit{3, -ray.direction, 1e-9, 0, 2.5};
    };
    const LightGuide all(cell, ball, survey_places_in(cell, {}, even), even, nullptr);
    CHECK(all.mean_luminance() == Approx(2.5));
    CHECK(all.noise_of_scattering() == Approx(0).margin(1e-12));
    const LightGuide some = outlook_of(cell);
    CHECK(some.mean_luminance() < 2.5);
    CHECK(some.noise_of_scattering() > 0.05);
}

TEST_CASE("no direction is drawn where nothing shines", "[lighting]") {
    const auto dark = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    const Box cell{Vec3(3, -2, 3), Vec3(4, -1, 4)};
    const LightGuide outlook(cell, ball, survey_places_in(cell, {}, dark), dark, nullptr);
    LightGuide::Weights weights;
    outlook.weigh({Vec3(3.5, -1.5, 3.5), Vec3(0, 1, 0)}, weights);
    CHECK(weights.total == 0);
    CHECK(std::isinf(outlook.noise()));
    CHECK(LightGuide::density(weights, Vec3(0, 1, 0)) == 0);
}

}  // namespace candelabra
