// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cell_survey.h"

#include "support/ball_over_floor.h"
#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

namespace {

const Box cell_at_floor{Vec3(2, -2, 2), Vec3(4, 0, 4)};

/// Surveys a cell that one glowing ball lights.
CellSurvey surveyed(const LightProbe& probe, bool in_air) {
    const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0), 1}, 2.5)};
    const LightTree tree(*choices(luminaires));
    const auto lights = choices(luminaires);
    const CellSurveyor survey(*lights, tree, {}, 0.9);
    LightCut cut(tree, *choices(luminaires), cell_at_floor, {});
    return survey(cell_at_floor, in_air, cut, probe);
}

}  // namespace

TEST_CASE("a survey tells the light of a cell, and the noise of sampling it", "[lighting]") {
    const CellSurvey found = surveyed(ball_over_floor, false);
    REQUIRE(found.outlook);
    CHECK(found.noise >= 0);
    CHECK(found.irradiance > 0);
    CHECK(found.by_direction >= 0);
    CHECK(found.by_direction <= 0.9);
}

TEST_CASE("in the air only chosen luminaires are surveyed", "[lighting]") {
    const CellSurvey found = surveyed(ball_over_floor, true);
    CHECK_FALSE(found.outlook);
    CHECK(found.by_direction == 0);
    CHECK(found.irradiance > 0);
}

TEST_CASE("a survey that meets no light tells no noise", "[lighting]") {
    const auto dark = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    CHECK(surveyed(dark, false).noise < 0);
}

TEST_CASE("small lamps beside a lobe get few directions of the surface", "[lighting]") {
    const auto share = [](double radius, double sharpness) {
        const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0), radius}, 2.5)};
        const LightTree tree(*choices(luminaires));
        const auto lights = choices(luminaires);
        LightCut cut(tree, *lights, cell_at_floor, {});
        const auto seen = [&](const Ray& ray, double tolerance) -> std::optional<ProbeHit> {
            const double along = -dot(ray.origin, ray.direction);
            const Vec3 off = ray.at(along);
            if (along > 0 && length(off) < radius)
                return ProbeHit{along, -ray.direction, 1e-9, 0, 2.5};
            const double t = (-1.5 - ray.origin.y) / ray.direction.y;
            if (t > tolerance) return ProbeHit{t, Vec3(0, 1, 0), 1e-9, {}, 0};
            return {};
        };
        const CellSurveyor survey(*lights, tree, {}, 0.9);
        const CellSurvey found = survey(cell_at_floor, false, cut, seen);
        REQUIRE(found.knows_by_surface());
        const Receiver point{Vec3(3, -1.5, 3), Vec3(0, 1, 0)};
        const Vec3 to_light = unit(-point.position), viewer(-to_light.x, to_light.y, -to_light.z);
        BsdfLobes metal{0, {Highlight{point.normal, 1, sharpness, viewer}}, 1};
        metal.highlights[0].peak = 1 / metal.highlights[0].albedo();
        CutWeights weights;
        cut.weigh(point, weights);
        cut.weigh_answers(point, metal, weights);
        return found.by_surface(weights, metal, survey.looks_of(cut, cell_at_floor));
    };
    CHECK(share(1, 100) > 0.5);
    CHECK(share(0.02, 100) < 0.1);
    CHECK(share(0.02, 1e6) > 0.5);
}

TEST_CASE("a survey scales the entries of a cut by the light that arrives", "[lighting]") {
    // Of two balls of the same light the second one is hidden: rays towards it meet nothing.
    const std::vector<Luminaire> luminaires = {glowing(SphereEmitter{Vec3(0), 1}, 2.5),
                                               glowing(SphereEmitter{Vec3(6, 0, 6), 1}, 2.5)};
    const LightTree tree(*choices(luminaires));
    LightCut cut(tree, *choices(luminaires), cell_at_floor, {});
    REQUIRE(cut.entries() == 2);
    const Receiver point{Vec3(3, -1.5, 3), Vec3(0, 1, 0)};
    CutWeights before, after;
    cut.weigh(point, before);
    CellSurveyor(*choices(luminaires), tree, {}, 0.9)(cell_at_floor, false, cut, ball_over_floor);
    cut.weigh(point, after);
    const auto entry_of = [&](LightIndex light) { return cut.entry_of(tree.place_of(light)); };
    const auto share = [&](const CutWeights& weights) {
        return weights.weight[entry_of(0)] / weights.total;
    };
    CHECK(share(before) == Approx(0.5).epsilon(0.01));
    CHECK(share(after) > 0.7);
    CHECK(share(after) < 1);
}

}  // namespace candelabra
