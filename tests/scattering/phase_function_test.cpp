// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/phase_function.h"

#include "base/random.h"
#include "scattering/scatterer.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

Media scattering_medium(int type, double colour, double eccentricity = 0) {
    Media media;
    media.scattering.type = type;
    media.scattering.colour = Rgb(colour);
    media.scattering.eccentricity = eccentricity;
    return media;
}

}  // namespace

TEST_CASE("directions are drawn as media scatter light", "[render]") {
    const Media hazy = scattering_medium(2, 0.3), murky = scattering_medium(3, 0.1),
                blue = scattering_medium(4, 0.5), forward = scattering_medium(5, 0.2, 0.6),
                back = scattering_medium(5, 0.2, -0.3), even = scattering_medium(1, 1);
    const std::vector<std::vector<const Media*>> mixtures = {
        {&hazy}, {&murky}, {&blue}, {&forward}, {&back}, {&even}, {&hazy, &back, &even}};
    const Vec3 view = unit(Vec3(1, -2, 3));
    for (const auto& mixture : mixtures) {
        const PhaseFunction phase(mixture, Vec3(0), view, {});
        CAPTURE(mixture.size(), mixture.front()->scattering.type);
        // The density matches the directions, and the response divided by it is constant.
        constexpr std::uint32_t count = 20000;
        double weight = 0, towards = 0, expected = 0, mean = 0;
        Key key;
        for (key.sample = 0; key.sample < count; ++key.sample) {
            const Vec2 u{uniform(key, Purpose::bounce_u), uniform(key, Purpose::bounce_v)};
            const Vec3 direction = phase.sample(u);
            CHECK(length(direction) == Approx(1));
            weight += phase.evaluate(direction).r / phase.pdf(direction) / count;
            towards += dot(direction, view) / count;
            // The same mean by uniform directions.
            const double cosine = 2 * u.x - 1;
            const auto [x, y] = perpendiculars(view);
            const Vec3 any = cosine * view + std::sqrt(1 - cosine * cosine) * x;
            expected += cosine * phase.pdf(any) * 4 * std::numbers::pi / count;
            mean += phase.evaluate(any).r / count;
        }
        CHECK(mean == Approx(phase.mean().r).epsilon(0.01));
        const PhaseFunction again(mixture, Vec3(0), view, {});
        CHECK(weight == Approx(again.evaluate(Vec3(view)).r / again.pdf(view)).epsilon(0.02));
        CHECK(towards == Approx(expected).margin(0.01));
    }
}

TEST_CASE("media draw directions with the density that is said, and light takes its way back",
          "[scattering]") {
    for (int type = 1; type <= 5; ++type)
        for (const double eccentricity : {-0.7, 0.0, 0.4, 0.9}) {
            if (type != 5 && eccentricity != 0) continue;
            const Media medium = scattering_medium(type, 0.4, eccentricity);
            const std::array<const Media*, 1> media = {&medium};
            const Vec3 view = unit(Vec3(1, -2, 3));
            const PhaseFunction phase(media, Vec3(0), view, {});
            CAPTURE(type, eccentricity);
            // By the cosine to the view: each bin's share by the density, in steps of equal
            // solid angle.
            constexpr int bins = 20, steps = 200;
            constexpr std::uint32_t count = 20000;
            const auto [x, y] = perpendiculars(view);
            const auto at = [&](double cosine) {
                return cosine * view + std::sqrt(1 - cosine * cosine) * x;
            };
            std::array<double, bins> said{}, drawn{};
            double all = 0;
            for (int i = 0; i < bins * steps; ++i) {
                const double cosine = 2 * (i + 0.5) / (bins * steps) - 1;
                const double share = phase.pdf(at(cosine)) * 4 * std::numbers::pi / (bins * steps);
                said[static_cast<std::size_t>(i / steps)] += share;
                all += share;
                const PhaseFunction back(media, Vec3(0), -at(cosine), {});
                CHECK(back.evaluate(-view).r == Approx(phase.evaluate(at(cosine)).r));
            }
            CHECK(all == Approx(1).epsilon(0.002));
            Key key;
            for (key.sample = 0; key.sample < count; ++key.sample) {
                const Vec3 d = phase.sample(
                    {uniform(key, Purpose::bounce_u), uniform(key, Purpose::bounce_v)});
                const int bin = std::min(static_cast<int>((dot(d, view) + 1) / 2 * bins), bins - 1);
                drawn[static_cast<std::size_t>(bin)] += 1.0 / count;
            }
            double squares = 0;
            for (std::size_t i = 0; i < bins; ++i)
                squares += (drawn[i] - said[i]) * (drawn[i] - said[i]) / (said[i] / count + 1e-7);
            CHECK(squares < bins + 5 * std::sqrt(2.0 * bins));
        }
}

TEST_CASE("what scatters nothing answers no light", "[render]") {
    Media clear;
    clear.emission = Rgb(1);
    const std::array<const Media*, 1> view = {&clear};
    const PhaseFunction phase(view, Vec3(1, 2, 3), Vec3(0, 0, 1), {});
    CHECK_FALSE(phase.answers_light());
    CHECK(phase.evaluate(Vec3(0, 0, 1)) == Rgb(0));
    const Scatterer scatterer(phase);
    CHECK(scatterer.in_air());
    CHECK(scatterer.phase().receiver().horizon == Horizon::none);
    CHECK(scatterer.phase().receiver().position == Vec3(1, 2, 3));
}

TEST_CASE("media of physical scattering send on what they take, and no more", "[render]") {
    for (int type = 1; type <= 5; ++type) {
        Media medium = scattering_medium(type, 0.3, 0.6), other = scattering_medium(1, 0.2);
        medium.scattering.physical = other.scattering.physical = true;
        const std::vector<const Media*> both = {&medium, &other};
        const PhaseFunction phase(both, Vec3(0), Vec3(0, 0, 1), {}, Rgb(2));
        CAPTURE(type);
        CHECK(phase.share().r == Approx(2 * coefficients(both, Vec3(0), {}).extinction.r));
    }
}

}  // namespace candelabra
