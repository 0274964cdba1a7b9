// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/paper_octree.h"

#include "lighting/linear_alpha.h"
#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const Receiver floor_point{Vec3(0.5, 0, 0.5), Vec3(0, 1, 0)};
const std::vector<Box> floor_box = {Box{Vec3(0), Vec3(1, 0, 1)}};

/// Lamps over the floor, so small and far away that none is bright.
std::vector<Luminaire> dim_lamps(int count, double height) {
    Draw draw(1);
    std::vector<Luminaire> result;
    for (int i = 0; i < count; ++i)
        result.push_back(glowing(SphereEmitter{0.1 * draw.point() + Vec3(0, height, 0), 0.01}));
    return result;
}

double sum_of_expected(const BuiltPaperOctree& built, const Receiver& point, std::size_t count,
                       const Key& key) {
    double sum = 0;
    for (LightIndex light = 0; light < count; ++light) sum += built.expected(point, key, light);
    return sum;
}

}  // namespace

TEST_CASE("where all luminaires are bright the light octree chooses as linear alpha does",
          "[lighting][claim-17]") {
    Draw draw(2);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 40; ++i)
        luminaires.push_back(glowing(emitter(i % emitter_kinds, draw.point(3), 0.3, draw), 1000));
    const std::vector<Box> room = {Box{Vec3(-3), Vec3(3)}};
    const BuiltPaperOctree built = BuiltPaperOctree(PaperOctree{}, {choices(luminaires), room}, 1);
    const BuiltLinearAlpha linear = build(LinearAlpha{}, {choices(luminaires), room}, 1);
    for (int i = 0; i < 100; ++i) {
        const Receiver point{draw.point(3), draw.direction()};
        REQUIRE(built.bright(point.position) == 40);
        const auto light = static_cast<LightIndex>(draw.number() * 40);
        CHECK(built.expected(point, {}, light) == Approx(linear.expected(point, {}, light)));
    }
}

TEST_CASE("dim luminaires that are alike are picked alike", "[lighting]") {
    const std::vector<Luminaire> luminaires = dim_lamps(100, 50);
    const BuiltPaperOctree built =
        BuiltPaperOctree(PaperOctree{}, {choices(luminaires), floor_box}, 1);
    CHECK(built.bright(floor_point.position) == 0);
    for (LightIndex light = 0; light < 100; ++light)
        CHECK(built.expected(floor_point, {}, light) == Approx(0.01));
}

TEST_CASE("one bright luminaire among dim ones gets its share", "[lighting]") {
    std::vector<Luminaire> luminaires = dim_lamps(100, 50);
    luminaires.insert(luminaires.begin() + 40, glowing(SphereEmitter{Vec3(0.5, 2, 0.5), 0.1}));
    const BuiltPaperOctree built =
        BuiltPaperOctree(PaperOctree{}, {choices(luminaires), floor_box}, 1);
    CHECK(built.bright(floor_point.position) == 1);
    const double bright = unoccluded(luminaires[40], floor_point),
                 dim = 100 * unoccluded(luminaires[0], floor_point);
    CHECK(built.expected(floor_point, {}, 40) == Approx(bright / (bright + dim)).epsilon(0.02));
    CHECK(sum_of_expected(built, floor_point, 101, {}) == Approx(1));
}

TEST_CASE("a dim set that is all below the horizon ends the search and keeps a chance",
          "[lighting][claim-13]") {
    // The paper would sample representatives for ever.
    std::vector<Luminaire> luminaires = dim_lamps(100, -50);
    const BuiltPaperOctree dark =
        BuiltPaperOctree(PaperOctree{}, {choices(luminaires), floor_box}, 1);
    for (std::uint32_t sample = 0; sample < 50; ++sample)
        CHECK(dark.expected(floor_point, {1, sample, 0, 0}, 7) > 0);
    luminaires.push_back(glowing(SphereEmitter{Vec3(0.5, 2, 0.5), 0.1}));
    const BuiltPaperOctree built =
        BuiltPaperOctree(PaperOctree{}, {choices(luminaires), floor_box}, 1);
    CHECK(built.expected(floor_point, {}, 100) > 0.9);
    CHECK(built.expected(floor_point, {}, 7) > 0);
}

TEST_CASE("points where no surface is are answered as well", "[lighting]") {
    std::vector<Luminaire> luminaires = dim_lamps(100, 5);
    const BuiltPaperOctree built =
        BuiltPaperOctree(PaperOctree{}, {choices(luminaires), floor_box}, 1);
    for (const Vec3& position :
         {Vec3(1e6, 0, 0), Vec3(0.5, -100, 0.5), Vec3(-3, 0.2, 0), Vec3(0, 5, 0)})
        CHECK(sum_of_expected(built, {position, Vec3(0, 1, 0), Horizon::both_sides}, 100, {}) ==
              Approx(1));
}

TEST_CASE("more representatives make a steadier guess", "[lighting][claim-13]") {
    Draw draw(3);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 500; ++i)
        luminaires.push_back(glowing(SphereEmitter{draw.point(60), 0.01}));
    luminaires.push_back(glowing(SphereEmitter{Vec3(0.5, 0.2, 0.5), 0.01}));
    double last = std::numeric_limits<double>::infinity();
    for (const int representatives : {1, 16}) {
        PaperOctree settings;
        settings.representatives = representatives;
        const BuiltPaperOctree built =
            BuiltPaperOctree(settings, {choices(luminaires), floor_box}, 1);
        double sum = 0, square = 0;
        for (std::uint32_t sample = 0; sample < 400; ++sample) {
            const double share = 1 - built.expected(floor_point, {1, sample, 0, 0}, 500);
            sum += share;
            square += share * share;
        }
        const double relative_variance = 400 * square / (sum * sum) - 1;
        CHECK(relative_variance < 0.6 * last);
        last = relative_variance;
    }
}

}  // namespace candelabra
