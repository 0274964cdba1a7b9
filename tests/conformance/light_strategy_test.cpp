// SPDX-License-Identifier: GPL-3.0-or-later
// How every light sampling strategy picks luminaires, run for each alternative of LightSampler:
// light_answer_test.cpp has directions and points.
#include "support/choices.h"
#include "support/strategies.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// What each luminaire gives at the point.
std::vector<double> irradiances(const Room& room, const Receiver& point) {
    std::vector<double> result;
    for (const Luminaire& luminaire : room.luminaires)
        result.push_back(unoccluded(luminaire, point));
    return result;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("picks tell their expected number, which is how often they come",
                        "[lighting]", Strategies) {
    const Room room(40, 1);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    Draw draw(2);
    constexpr int trials = 3000;
    for (std::uint64_t pixel = 0; pixel < 12; ++pixel) {
        const Receiver point = room.point(draw);
        std::vector<double> counted(40), expected(40), evened(40), inverse(40);
        const Asked asked(built, point);
        for (int trial = 0; trial < trials; ++trial) {
            for (const LightPick& pick : asked.picks(key_of(pixel, trial))) {
                REQUIRE(pick.light < 40);
                CHECK(pick.expected ==
                      Approx(asked.expected(key_of(pixel, trial), pick.light)).epsilon(1e-9));
                CHECK(pick.expected > 0);
                counted[pick.light] += 1;
                evened[pick.light] += 1 / pick.expected;
            }
            for (LightIndex light = 0; light < 40; ++light) {
                const double chance = asked.expected(key_of(pixel, trial), light);
                expected[light] += chance;
                inverse[light] += 1 / std::fmax(chance, 1e-6);
            }
        }
        double chi2 = 0, rare_counted = 0, rare_expected = 0;
        int groups = 0;
        for (LightIndex light = 0; light < 40; ++light) {
            if (expected[light] < 10) {
                rare_counted += counted[light];
                rare_expected += expected[light];
                continue;
            }
            chi2 += std::pow(counted[light] - expected[light], 2) / expected[light];
            ++groups;
            // The sum of 1 / expected over the picks of a luminaire is 1 a trial, on average.
            const double sigma = std::sqrt((inverse[light] / trials - 1) / trials);
            if (sigma < 0.15) CHECK(std::abs(evened[light] / trials - 1) <= 4.5 * sigma + 1e-9);
        }
        INFO("point " << pixel);
        CHECK(chi2 <= groups + 5 * std::sqrt(2.0 * groups));
        CHECK(std::abs(rare_counted - rare_expected) <= 5 * std::sqrt(rare_expected) + 1);
    }
}

TEMPLATE_LIST_TEST_CASE("no luminaire that can light a point has no chance there", "[lighting]",
                        Strategies) {
    // 10^5 points inside, near and far, half of them with the luminaire across the horizon.
    Draw draw(3);
    int lit = 0, impossible = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Room room(30, 100 + seed);
        const auto built = built_with(settings<TestType>(), room.scene(), 1);
        for (int i = 0; i < 1000; ++i) {
            const auto light = static_cast<LightIndex>(draw.number() * 30);
            const LightBounds b = bounds(room.luminaires[light]);
            Receiver point = room.point(draw);
            if (i % 4 != 0) point.position = point_around(b.centre, b.radius, draw);
            const auto s =
                sample(room.luminaires[light], point.position, {draw.number(), draw.number()});
            if (!s) continue;
            if (i % 2 == 0) {
                const Vec3 level = cross(cross(s->direction, point.normal), s->direction);
                if (point.horizon != Horizon::none)
                    point.normal =
                        unit(unit(level) + std::pow(10, draw.between(-9, 0)) * s->direction);
            }
            if (!(point.cosine(s->direction) > 1e-12)) continue;
            ++lit;
            impossible += !(Asked(built, point).expected(key_of(seed, i), light) > 0);
        }
    }
    CHECK(lit > 50000);
    CHECK(impossible == 0);
}

TEMPLATE_LIST_TEST_CASE("the light that a strategy finds is what all luminaires give", "[lighting]",
                        Strategies) {
    Draw draw(4);
    for (const int count : {1, 5, 300}) {
        const Room room(count, 5);
        const auto built = built_with(settings<TestType>(), room.scene(), 1);
        for (std::uint64_t pixel = 0; pixel < 5; ++pixel) {
            const Receiver point = room.point(draw);
            const Asked asked(built, point);
            constexpr int trials = 4000;
            const std::vector<double> each = irradiances(room, point);
            double all = 0, unlikely = 0, guessed = 0;
            for (LightIndex light = 0; light < each.size(); ++light) {
                all += each[light];
                const double chance = asked.expected(key_of(pixel, 0), light);
                if (trials * chance < 10) unlikely += each[light];
                guessed += trials * chance < 10 ? chance : 0;
            }
            double sum = 0, square = 0;
            for (int trial = 0; trial < trials; ++trial) {
                double y = 0;
                for (const LightPick& pick : asked.picks(key_of(pixel, trial)))
                    y += each[pick.light] / pick.expected;
                sum += y;
                square += y * y;
            }
            const double mean = sum / trials,
                         sigma = std::sqrt(std::fmax(0, square / trials - mean * mean) / trials);
            INFO(count << " luminaires, point " << pixel);
            // Those that are hardly ever picked may be missing, and so may the share that others
            // left to them.
            CHECK(std::abs(mean - all) <= 4 * sigma + unlikely + (guessed + 1e-6) * all);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the scale of a scene changes no choice", "[lighting]", Strategies) {
    // Cuts weigh in single precision, whose rounding another scale changes; the others in double.
    const bool single_precision = std::is_same_v<TestType, LightOctree>;
    const double rounding = single_precision ? 1e-4 : 1e-9;
    const Room room(60, 6);
    const auto built = built_with(settings<TestType>(), room.scene(), 1);
    for (const double scale : {1e-3, 1e3}) {
        const Room scaled(60, 6, scale);
        const auto other = built_with(settings<TestType>(), scaled.scene(), 1);
        Draw draw(7), again(7);
        for (int i = 0; i < 300; ++i) {
            const Receiver point = room.point(draw), there = scaled.point(again);
            const auto light = static_cast<LightIndex>(draw.number() * 60);
            again.number();
            CHECK(Asked(other, there).expected(key_of(1, i), light) ==
                  Approx(Asked(built, point).expected(key_of(1, i), light))
                      .epsilon(rounding)
                      .margin(1e-20));
        }
    }
}

TEMPLATE_LIST_TEST_CASE(
    "a strategy without luminaires, or where nothing is above the horizon, picks nothing that "
    "shines",
    "[lighting]", Strategies) {
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    const Box surface{Vec3(-1), Vec3(1)};
    for (const LightScene& scene : {LightScene{{}, {&surface, 1}}, LightScene{}}) {
        const auto built = built_with(settings<TestType>(), scene, 1);
        CHECK(Asked(built, point).picks(key_of(1, 1)).empty());
    }

    const std::vector<Luminaire> below(20, glowing(SphereEmitter{Vec3(0, -5, 0), 1}));
    const auto built =
        built_with(settings<TestType>(), LightScene{choices(below), {&surface, 1}}, 1);
    for (int i = 0; i < 100; ++i)
        for (const LightPick& pick : Asked(built, point).picks(key_of(1, i)))
            CHECK(pick.expected > 0);
}

TEMPLATE_LIST_TEST_CASE("coincident, dark, faint and glaring luminaires are all right",
                        "[lighting]", Strategies) {
    std::vector<Luminaire> luminaires;
    for (const double radiance : {1.0, 1.0, 0.0, -3.0, 1e-300, 1e-12, 1e12, 1e300})
        luminaires.push_back(glowing(SphereEmitter{Vec3(0, 3, 0), 1}, radiance));
    const Box surface{Vec3(-1), Vec3(1)};
    const auto built =
        built_with(settings<TestType>(), LightScene{choices(luminaires), {&surface, 1}}, 1);
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    const Asked asked(built, point);
    std::size_t picked = 0;
    for (int i = 0; i < 500; ++i)
        for (const LightPick& pick : asked.picks(key_of(2, i))) {
            ++picked;
            CHECK(std::isfinite(1 / pick.expected));
            CHECK(pick.expected > 0);
        }
    CHECK(picked >= 490);
    for (const LightIndex light : {0u, 1u, 4u, 5u, 6u, 7u})
        CHECK(asked.expected(key_of(2, 0), light) > 0);
}

TEMPLATE_LIST_TEST_CASE("a strategy does not depend on the number of threads that built it",
                        "[lighting]", Strategies) {
    const Room room(200, 8);
    const auto one = built_with(settings<TestType>(), room.scene(), 1),
               seven = built_with(settings<TestType>(), room.scene(), 7);
    CHECK(one.memory_bytes() == seven.memory_bytes());
    Draw draw(9);
    for (int i = 0; i < 200; ++i) {
        const Receiver point = room.point(draw);
        const LightPicks a = Asked(one, point).picks(key_of(3, i)),
                         b = Asked(seven, point).picks(key_of(3, i));
        REQUIRE(a.size() == b.size());
        for (std::size_t p = 0; p < a.size(); ++p) {
            CHECK(a[p].light == b[p].light);
            CHECK(a[p].expected == b[p].expected);
        }
    }
}

}  // namespace candelabra
