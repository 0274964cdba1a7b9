// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_octree.h"

#include "lighting/linear_alpha.h"
#include "support/choices.h"
#include "support/strategies.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

namespace candelabra {

namespace {

struct Street {
    std::vector<Luminaire> luminaires;
    std::vector<Box> ground = {Box{Vec3(-50, 0, -50), Vec3(50, 0, 50)}};

    explicit Street(int count) {
        Draw draw(1);
        for (int i = 0; i < count; ++i) {
            const Vec3 place = 50.0 * draw.point();
            luminaires.push_back(
                glowing(SphereEmitter{{place.x, 1 + std::abs(place.y) / 10, place.z}, 0.05},
                        std::pow(10, draw.between(0, 1))));
        }
    }
    LightScene scene() const { return {choices(luminaires), ground}; }
    Receiver point(Draw& draw) const {
        return {Vec3(draw.between(-50, 50), 0, draw.between(-50, 50)), Vec3(0, 1, 0)};
    }
};

/// Variance over squared mean of the choice without occlusion.
double noise(const Street& street, const BuiltCutOctree& built, const Receiver& point) {
    const Asked asked(built, point);
    double sum = 0, square = 0;
    for (LightIndex light = 0; light < street.luminaires.size(); ++light) {
        const double given = unoccluded(street.luminaires[light], point);
        sum += given;
        if (given > 0) square += given * given / asked.expected(Key{}, light);
    }
    return square / (sum * sum) - 1;
}

}  // namespace

TEST_CASE("the choice from cuts is nearly as good as that from all luminaires", "[lighting]") {
    const Street street(3000);
    // Cells that look small, or without an eye, are divided down to a bound of 20 times eta, which
    // is 0.4; cells that look large are divided further. The bound is rough: the mean stays well
    // below it, and single points near a lamp may be somewhat above.
    LightScene seen = street.scene();
    seen.eye = Vec3(0, 5, 0);
    seen.pixel = 1e-6;
    for (const bool large : {false, true}) {
        const BuiltCutOctree built(LightOctree{}, large ? seen : street.scene());
        Draw draw(2);
        double sum = 0, worst = 0;
        for (int i = 0; i < 300; ++i) {
            const double here = noise(street, built, street.point(draw));
            sum += here;
            worst = std::fmax(worst, here);
        }
        CAPTURE(large, sum / 300, worst);
        CHECK(sum / 300 < 0.2);
        CHECK(worst < 1);
    }
}

TEST_CASE("all chances add up to 1", "[lighting]") {
    const Street street(500);
    LightOctree settings;
    settings.cut = 9;
    const BuiltCutOctree built(settings, street.scene());
    Draw draw(3);
    for (int i = 0; i < 100; ++i) {
        const Receiver point = street.point(draw);
        const Asked asked(built, point);
        double sum = 0;
        for (LightIndex light = 0; light < 500; ++light) sum += asked.expected(Key{}, light);
        CHECK(sum == Approx(1));
    }
}

TEST_CASE("samples that are made together are those that are made alone", "[lighting]") {
    const Street street(500);
    const BuiltCutOctree built(LightOctree{}, street.scene());
    Draw draw(4);
    const BsdfLobes lobes;
    for (int i = 0; i < 20; ++i) {
        const Receiver point = street.point(draw);
        const auto answer = built.at({point, lobes, nullptr, nullptr});
        std::vector<Key> keys;
        for (std::uint32_t n = 0; n < 5; ++n) keys.push_back(Key::of(Survey::cell, 1, n, 0));
        std::vector<LightSamples> together(keys.size());
        answer.sample(std::span<const Key>(keys), std::span<LightSamples>(together));
        for (std::size_t n = 0; n < keys.size(); ++n) {
            LightSamples alone;
            answer.sample(keys[n], alone);
            REQUIRE(alone.picks.size() == 1);
            REQUIRE(together[n].picks.size() == 1);
            CHECK(together[n].picks[0].light == alone.picks[0].light);
            CHECK(together[n].picks[0].expected == alone.picks[0].expected);
        }
    }
}

TEST_CASE("cells are made where they are asked for, whoever comes first", "[lighting]") {
    const Street street(2000);
    const BuiltCutOctree one(LightOctree{}, street.scene()), many(LightOctree{}, street.scene());
    CHECK(one.cells() == 0);
    std::vector<Receiver> points;
    Draw draw(4);
    for (int i = 0; i < 400; ++i) points.push_back(street.point(draw));
    std::vector<std::vector<double>> answers(2, std::vector<double>(points.size()));
    const auto ask = [&](const BuiltCutOctree& built, std::vector<double>& out, std::size_t i) {
        out[i] = Asked(built, points[i]).expected(Key{}, static_cast<LightIndex>(5 * i));
    };
    for (std::size_t i = 0; i < points.size(); ++i) ask(one, answers[0], i);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (std::size_t i = points.size(); i-- > 0;)
                if (i % 4 == t) ask(many, answers[1], i);
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(answers[0] == answers[1]);
    CHECK(one.cells() > 0);
    CHECK(one.cells() == many.cells());
    CHECK(one.memory_bytes() == many.memory_bytes());
}

TEST_CASE("a cell that several threads survey at a time counts once", "[lighting]") {
    const Street street(200);
    const auto dark = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    const auto bytes = [&](int threads) {
        const BuiltCutOctree built(LightOctree{}, street.scene());
        const auto ask_everywhere = [&] {
            Draw draw(5);
            for (int i = 0; i < 100; ++i) {
                const Receiver point = street.point(draw);
                const LightProbe probe(dark);
                const BsdfLobes lobes;
                built.at({point, lobes, nullptr, &probe});
            }
        };
        std::vector<std::thread> asking;
        for (int t = 0; t < threads; ++t) asking.emplace_back(ask_everywhere);
        for (std::thread& thread : asking) thread.join();
        return built.memory_bytes();
    };
    const std::size_t alone = bytes(1);
    for (int trial = 0; trial < 5; ++trial) CHECK(bytes(4) == alone);
}

TEST_CASE("the light of lamps that few directions meet is expected as well", "[lighting]") {
    // Tiny lamps give most of the light; the rays that look around meet the large ball only.
    std::vector<Luminaire> luminaires = {glowing(SphereEmitter{{0, 12, 0}, 4}, 0.001)};
    Draw draw(6);
    for (int i = 0; i < 200; ++i) {
        const Vec3 place = 20.0 * draw.point();
        luminaires.push_back(
            glowing(SphereEmitter{{place.x, 8 + std::abs(place.y), place.z}, 0.005}, 1000));
    }
    const std::vector<Box> ground = {Box{Vec3(-5, 0, -5), Vec3(5, 0, 5)}};
    const auto look = [&](const Ray& ray, double tolerance) {
        std::optional<ProbeHit> nearest;
        for (LightIndex light = 0; light < luminaires.size(); ++light) {
            const auto& ball = std::get<SphereEmitter>(luminaires[light].emitter);
            const Vec3 to = ball.centre - ray.origin;
            const double along = dot(to, ray.direction),
                         square = ball.radius * ball.radius - (dot(to, to) - along * along);
            const double distance = square > 0 ? along - std::sqrt(square) : -1;
            if (!(distance > tolerance) || (nearest && nearest->distance < distance)) continue;
            nearest = ProbeHit{distance, unit(ray.at(distance) - ball.centre), 1e-9, light,
                               luminance(luminaires[light].radiance)};
        }
        return nearest;
    };
    const LightProbe probe(look);
    const BuiltCutOctree built(LightOctree{}, {choices(luminaires), ground});
    const BsdfLobes lobes;
    for (int i = 0; i < 20; ++i) {
        const Receiver point{Vec3(draw.between(-5, 5), 0, draw.between(-5, 5)), Vec3(0, 1, 0)};
        const auto estimate = built.at({point, lobes, nullptr, &probe}).estimate();
        REQUIRE((estimate && estimate->ray));
        double irradiance = 0;
        for (const Luminaire& luminaire : luminaires) {
            const auto& ball = std::get<SphereEmitter>(luminaire.emitter);
            const Vec3 to = ball.centre - point.position;
            irradiance += std::numbers::pi * ball.radius * ball.radius / dot(to, to) *
                          dot(unit(to), point.normal) * luminance(luminaire.radiance);
        }
        CHECK(estimate->ray->irradiance > 0.5 * irradiance);
    }
}

TEST_CASE("points far outside of the cells are answered as well", "[lighting]") {
    const Street street(100);
    const BuiltCutOctree built(LightOctree{}, street.scene());
    for (const Vec3& position : {Vec3(1e6, 0, 0), Vec3(0, -1e4, 0), Vec3(-60, 0.2, 70)}) {
        double sum = 0;
        const Receiver point{position, unit(-position)};
        const Asked asked(built, point);
        for (LightIndex light = 0; light < 100; ++light) sum += asked.expected(Key{}, light);
        CHECK(sum == Approx(1));
    }
}

}  // namespace candelabra
