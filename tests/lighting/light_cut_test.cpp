// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_cut.h"

#include "support/choices.h"
#include "support/lights.h"
#include "world/source_choices.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

const Box cell{Vec3(-1), Vec3(1)};

std::vector<Luminaire> lamps(int count) {
    Draw draw(1);
    std::vector<Luminaire> result;
    for (int i = 0; i < count; ++i)
        result.push_back(glowing(
            emitter(i % emitter_kinds, draw.point(5), std::pow(10, draw.between(-2, -0.5)), draw),
            std::pow(10, draw.between(-2, 2))));
    return result;
}

}  // namespace

TEST_CASE("a cut holds every luminaire once", "[lighting]") {
    for (const int count : {1, 2, 15, 16, 17, 500})
        for (const int most : {1, 7, 64, 256}) {
            const std::vector<Luminaire> luminaires = lamps(count);
            const LightTree tree(*choices(luminaires));
            const LightCut cut(tree, *choices(luminaires), cell, {1e-9, most});
            CHECK(cut.entries() <= static_cast<std::size_t>(most));
            std::uint32_t next = 0;
            for (std::size_t i = 0; i < cut.entries(); ++i) {
                CHECK(cut.cluster(i).first == next);
                next += cut.cluster(i).count;
                for (std::uint32_t place = cut.cluster(i).first; place < next; ++place)
                    CHECK(cut.entry_of(place) == i);
            }
            CHECK(next == luminaires.size());
        }
}

TEST_CASE("a part of the weights is shared evenly by the entries that have any", "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(200);
    const LightTree tree(*choices(luminaires));
    const LightCut cut(tree, *choices(luminaires), cell, {1e-9, 100});
    const Receiver point{Vec3(0.2, 0.1, 0), Vec3(0, 1, 0), Horizon::one_side};
    CutWeights before, after;
    cut.weigh(point, before);
    cut.weigh(point, after);
    cut.share_evenly(0.2, after);
    CHECK(after.total == Approx(1.2 * before.total));
    std::size_t lit = 0;
    for (std::size_t i = 0; i < cut.entries(); ++i) lit += before.weight[i] > 0 ? 1 : 0;
    REQUIRE((lit > 20 && lit < cut.entries()));
    const double each = 0.2 * before.total / static_cast<double>(lit);
    for (std::size_t i = 0; i < cut.entries(); ++i)
        CHECK(after.weight[i] == Approx(before.weight[i] > 0 ? before.weight[i] + each : 0));
}

TEST_CASE("more entries make less noise, and the bound is kept where they suffice", "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(200);
    const LightTree tree(*choices(luminaires));
    double last = std::numeric_limits<double>::infinity();
    for (const int most : {1, 16, 64, 256}) {
        const LightCut cut(tree, *choices(luminaires), cell, {1e-9, most});
        CHECK(cut.noise() < last);
        last = cut.noise();
    }
    CHECK(last == Approx(0).margin(1e-12));
    const LightCut loose(tree, *choices(luminaires), cell, {0.5, 256});
    CHECK(loose.noise() <= 0.5);
    CHECK(loose.entries() < 150);
}

TEST_CASE("an entry of one luminaire weighs what it gives", "[lighting]") {
    std::vector<Luminaire> luminaires;
    Draw draw(2);
    for (int i = 0; i < 40; ++i)
        luminaires.push_back(
            glowing(SphereEmitter{draw.point(5), 0.1}, std::pow(10, draw.between(-2, 2))));
    const LightTree tree(*choices(luminaires));
    const LightCut cut(tree, *choices(luminaires), cell, {1e-9, 64});
    REQUIRE(cut.entries() == 40);
    for (int i = 0; i < 100; ++i) {
        const Receiver point{draw.point(1), draw.direction(), lit_from(i % 5 == 0)};
        CutWeights weights;
        cut.weigh(point, weights);
        double sum = 0;
        for (const Luminaire& luminaire : luminaires) sum += unoccluded(luminaire, point);
        for (std::size_t entry = 0; entry < 40; ++entry) {
            const LightIndex light = tree.light(cut.cluster(entry).first);
            const double given = unoccluded(luminaires[light], point) / sum;
            CHECK(weights.weight[entry] / weights.total ==
                  Approx(given).epsilon(1e-3).margin(1e-5));
            if (given > 0) CHECK(weights.weight[entry] > 0);
        }
    }
}

TEST_CASE("the albedo of a highlight is its mean reflectance", "[lighting]") {
    const Vec3 normal(0, 0, 1), viewer = unit(Vec3(0.3, 0.2, 1));
    for (const double sharpness : {30.0, 300.0})
        for (const Highlight& h : {Highlight{normal, 2, sharpness, viewer},
                                   Highlight{Vec3(-viewer.x, -viewer.y, viewer.z), 2, sharpness}}) {
            constexpr int steps = 400;
            double sum = 0;
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const double height = (i + 0.5) / steps,
                                 across = std::sqrt(1 - height * height);
                    const double turn = 2 * std::numbers::pi * (j + 0.5) / steps;
                    sum += h.reflected({across * std::cos(turn), across * std::sin(turn), height});
                }
            // Over pi, and times the solid angle of a step.
            CHECK(h.albedo() == Approx(2 * sum / (steps * steps)).epsilon(0.1));
        }
}

TEST_CASE("an entry weighs what a surface that shines answers", "[lighting]") {
    std::vector<Luminaire> luminaires;
    Draw draw(6);
    for (int i = 0; i < 60; ++i)
        luminaires.push_back(glowing(SphereEmitter{draw.point(5), 0.001}, 1));
    const LightTree tree(*choices(luminaires));
    const LightCut cut(tree, *choices(luminaires), cell, {1e-9, 64});
    REQUIRE(cut.entries() == 60);
    for (int i = 0; i < 100; ++i) {
        const Receiver point{draw.point(1), draw.direction(), lit_from(i % 5 == 0)};
        const Vec3 normal = draw.direction(), viewer = draw.direction();
        BsdfLobes gloss{0.3, {Highlight{draw.direction(), 0.5, 40}}, 2};
        gloss.highlights[1] = i % 2 ? Highlight{normal, 5, 300, viewer} : Highlight{normal, 5, 900};
        CutWeights weights, plain;
        cut.weigh(point, plain);
        weights = plain;
        cut.weigh_answers(point, gloss, weights);
        double sum = 0;
        for (std::size_t entry = 0; entry < 60; ++entry) {
            const LightBounds b = bounds(luminaires[tree.light(cut.cluster(entry).first)]);
            const Vec3 direction = unit(b.centre - point.position);
            const double cosine = std::abs(dot(direction, point.normal));
            double answer = gloss.diffuse;
            for (const Highlight& h : gloss.highlights) answer += h.reflected(direction) / cosine;
            sum += weights.weight[entry];
            CHECK((weights.weight[entry] > 0) == (plain.weight[entry] > 0));
            if (cosine > 0.1)
                CHECK(weights.weight[entry] == Approx(answer * plain.weight[entry]).epsilon(0.02));
        }
        CHECK(weights.total == Approx(sum));
    }
}

TEST_CASE("an entry with a bent normal weighs less behind itself, but something everywhere",
          "[lighting]") {
    for (const int kind : {0, 3}) {
        Draw draw(4);
        std::vector<Luminaire> luminaires;
        // Twenty luminaires in a heap that shine one way, and a far one that shines all around.
        for (int i = 0; i < 20; ++i) {
            luminaires.push_back(
                glowing(emitter(kind, Vec3(0, 0, 10) + draw.point(0.1), 0.1, draw)));
        }
        luminaires.push_back(glowing(SphereEmitter{Vec3(500, 0, 10), 1}));
        std::vector<Vec3> bent_normals(20, Vec3(0, 0, -0.48));
        bent_normals.push_back(Vec3(0));
        const LuminaireChoices lights(luminaires, bent_normals);
        const LightTree tree(lights);
        for (const int most : {2, 64}) {
            const LightCut cut(tree, lights, cell, {1e-9, most});
            const auto seen_from = [&](double z) {
                CutWeights weights;
                cut.weigh({Vec3(0, 0, z), Vec3(0, 0, z < 10 ? 1 : -1)}, weights);
                double sum = 0;
                for (std::size_t i = 0; i < cut.entries(); ++i) {
                    CHECK(weights.weight[i] > 0);
                    const LightIndex light = tree.light(cut.cluster(i).first);
                    if (light < 20) sum += weights.weight[i];
                }
                return sum;
            };
            CHECK(seen_from(0) > 4 * seen_from(20));
        }
    }
}

TEST_CASE("an entry of one light source weighs what it gives", "[lighting][claim-28]") {
    std::vector<ChoosableSource> sources;
    Draw draw(3);
    for (int i = 0; i < 40; ++i) {
        Falloff falloff;
        falloff.fade_distance = i % 3 == 0 ? 0 : draw.between(0.1, 10);
        falloff.fade_power = draw.between(0.5, 4);
        if (i % 2 == 0) {
            falloff.axis = draw.direction();
            falloff.dark = draw.between(0.3, 1.5);
            falloff.bright = draw.between(0, falloff.dark);
        }
        sources.push_back({draw.point(5), 1e-5, falloff, std::pow(10, draw.between(-2, 2))});
    }
    const SourceChoices lights(sources);
    const LightTree tree(lights);
    const LightCut cut(tree, lights, cell, {1e-9, 64});
    // Cones that miss the cell need not be distinguished.
    REQUIRE(cut.entries() > 30);
    for (int i = 0; i < 100; ++i) {
        const Receiver point{draw.point(1), draw.direction(), lit_from(i % 5 == 0)};
        CutWeights weights;
        cut.weigh(point, weights);
        double sum = 0;
        for (LightIndex light = 0; light < 40; ++light) sum += lights.unoccluded(light, point);
        for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
            double given = 0;
            const LightCluster& c = cut.cluster(entry);
            for (std::uint32_t place = c.first; place < c.first + c.count; ++place)
                given += lights.unoccluded(tree.light(place), point) / sum;
            if (c.count > 1) CHECK(given == 0);
            CHECK(weights.weight[entry] / weights.total == Approx(given).epsilon(0.1).margin(1e-3));
            if (given > 0) CHECK(weights.weight[entry] > 0);
        }
    }
}

TEST_CASE("entries are found in proportion to their weights", "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(100);
    const LightTree tree(*choices(luminaires));
    const LightCut cut(tree, *choices(luminaires), cell, {1e-9, 50});
    CutWeights weights;
    cut.weigh({Vec3(0.3), Vec3(0, 1, 0)}, weights);
    std::vector<double> counted(cut.entries());
    constexpr int draws = 20000;
    for (int i = 0; i < draws; ++i) {
        double target = (i + 0.5) / draws * weights.total;
        const std::size_t entry = cut.find(weights, target);
        CHECK(target >= 0);
        CHECK(target < weights.weight[entry]);
        ++counted[entry];
    }
    for (std::size_t i = 0; i < cut.entries(); ++i)
        CHECK(std::abs(counted[i] / draws - weights.weight[i] / weights.total) < 2.0 / draws);
    double beyond = 2 * weights.total;
    CHECK(weights.weight[cut.find(weights, beyond)] > 0);
}

}  // namespace candelabra
