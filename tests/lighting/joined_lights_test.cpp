// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/joined_lights.h"

#include "lighting/cut_octree.h"
#include "support/choices.h"
#include "support/lights.h"
#include "support/strategies.h"
#include "world/source_choices.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

namespace candelabra {

namespace {

/// Small spheres and fading points of about the same light, some thousand times as bright as
/// others.
struct Mixture {
    std::vector<Luminaire> luminaires;
    std::vector<ChoosableSource> sources;
    std::vector<Box> ground = {Box{Vec3(-9, 0, -9), Vec3(9, 0, 9)}};
    std::shared_ptr<const ChoosableLights> lights;

    Mixture(int lamps, int points) {
        Draw draw(5);
        const auto place = [&] { return Vec3(0, 2, 0) + draw.point(9) * Vec3(1, 0.1, 1); };
        for (int i = 0; i < lamps; ++i)
            luminaires.push_back(
                glowing(SphereEmitter{place(), 0.05}, std::pow(10, draw.between(1, 4))));
        for (int i = 0; i < points; ++i) {
            Falloff falloff;
            falloff.fade_distance = draw.between(0.3, 3);
            falloff.fade_power = i % 4;
            if (i % 3 == 0) {
                falloff.axis = draw.direction();
                falloff.dark = draw.between(0.3, 1.5);
                falloff.bright = draw.between(0, falloff.dark);
            }
            sources.push_back({place(), 1e-5, falloff, std::pow(10, draw.between(-2, 1))});
        }
        lights = std::make_shared<JoinedLights>(choices(luminaires),
                                                std::make_shared<SourceChoices>(sources));
    }
    Receiver point(Draw& draw, int number) const {
        const Vec3 where(draw.between(-9, 9), 0.01, draw.between(-9, 9));
        if (number % 3 == 0) return {where + Vec3(0, 1, 0), Vec3(0), Horizon::none};
        return {where, Vec3(0, 1, 0), lit_from(number % 3 == 1)};
    }
};

}  // namespace

TEST_CASE("joined lights are those of one kind, and after them those of the other", "[lighting]") {
    const Mixture mixture(3, 2);
    const ChoosableLights& lights = *mixture.lights;
    REQUIRE(lights.size() == 5);
    CHECK(lights.falls_off());
    const Receiver point{Vec3(0), Vec3(0, 1, 0), Horizon::one_side};
    const auto own = choices(mixture.luminaires);
    const SourceChoices sources(mixture.sources);
    for (LightIndex light = 0; light < 5; ++light) {
        const bool first = light < 3;
        const ChoosableLights& kind = first ? *own : sources;
        const LightIndex number = first ? light : light - 3;
        CAPTURE(light);
        CHECK(lights.bounds(light).centre == kind.bounds(number).centre);
        CHECK(lights.has_surface(light) == first);
        CHECK(lights.falloff(light).has_value() == !first);
        CHECK(lights.unoccluded(light, point) == kind.unoccluded(number, point));
    }
}

TEST_CASE("a tree has the lights of each law apart", "[lighting]") {
    for (const auto& [lamps, points] :
         {std::pair{1, 1}, {1, 40}, {40, 1}, {300, 200}, {0, 5}, {5, 0}}) {
        const Mixture mixture(lamps, points);
        const LightTree tree(*mixture.lights);
        CAPTURE(lamps, points);
        CHECK(tree.has_both_laws() == (lamps > 0 && points > 0));
        const LightCluster lit = tree.by_square_law();
        CHECK(lit.count == static_cast<std::uint32_t>(lamps));
        for (LightIndex light = 0; light < mixture.lights->size(); ++light) {
            const std::uint32_t place = tree.place_of(light);
            CHECK(lit.holds(place) == (light < static_cast<LightIndex>(lamps)));
        }
    }
}

TEST_CASE("entries of both laws weigh what they give, in one unit", "[lighting]") {
    const Mixture mixture(20, 20);
    const LightTree tree(*mixture.lights);
    for (const double size : {0.03, 1.0, 7.0}) {
        const Box cell{Vec3(-size, 0, -size), Vec3(size, 0.1, size)};
        const LightCut cut(tree, *mixture.lights, cell, {1e-9, 64});
        REQUIRE(cut.has_both_laws());
        Draw draw(2);
        for (int i = 0; i < 60; ++i) {
            Receiver point = mixture.point(draw, i);
            point.position = Vec3(0, 0.05, 0) + size * draw.point() * Vec3(1, 0.05 / size, 1);
            CutWeights weights;
            cut.weigh(point, weights);
            double of_sources = 0, all = 0;
            for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
                const LightCluster& c = cut.cluster(entry);
                double given = 0;
                for (std::uint32_t place = c.first; place < c.first + c.count; ++place)
                    given += mixture.lights->unoccluded(tree.light(place), point);
                if (c.count == 1)
                    CHECK(weights.weight[entry] * cut.unit() ==
                          Approx(given).epsilon(0.1).margin(1e-3));
                all += weights.weight[entry];
                if (tree.falloff(c)) of_sources += weights.weight[entry];
            }
            CHECK(cut.share_of_sources(weights) == Approx(of_sources / all));
            const double before = weights.total;
            cut.dim_luminaires(0.25, weights);
            CHECK(weights.total == Approx(of_sources + 0.25 * (before - of_sources)));
        }
    }
}

TEST_CASE("one draw gives each light of both kinds its chance, and all chances add up to 1",
          "[lighting]") {
    for (const auto& [lamps, points, cut] : {std::tuple{300, 200, 64}, {7, 400, 9}, {2, 1, 1}}) {
        const Mixture mixture(lamps, points);
        LightOctree settings;
        settings.cut = cut;
        const BuiltCutOctree built(settings, {mixture.lights, mixture.ground});
        Draw draw(3);
        for (int i = 0; i < 20; ++i) {
            const Receiver point = mixture.point(draw, i);
            const Asked asked(built, point);
            double sum = 0;
            std::vector<double> expected, found(mixture.lights->size());
            for (LightIndex light = 0; light < mixture.lights->size(); ++light) {
                expected.push_back(asked.expected(Key{}, light));
                sum += expected.back();
                if (mixture.lights->unoccluded(light, point) > 0) CHECK(expected.back() > 0);
            }
            CHECK(sum == Approx(1));
            if (i > 2) continue;
            constexpr int draws = 20000;
            for (std::uint32_t j = 0; j < draws; ++j) {
                const LightPicks picks = asked.picks(key_of(1, static_cast<int>(j)));
                REQUIRE(picks.size() == 1);
                const LightPick& pick = picks[0];
                CHECK(pick.expected == Approx(expected[pick.light]));
                found[pick.light] += 1.0 / draws;
            }
            for (LightIndex light = 0; light < found.size(); ++light)
                CHECK(std::abs(found[light] - expected[light]) <
                      5 * std::sqrt(expected[light] / draws) + 1e-3);
        }
    }
}

}  // namespace candelabra
