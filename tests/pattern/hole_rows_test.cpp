// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/hole_rows.h"

#include "pattern/values.h"

#include <random>

namespace candelabra {

namespace {

double share(std::mt19937& random) { return std::uniform_real_distribution<>()(random); }

/// Returns black holes at random places, some of them overlapping, with other steps between them.
std::vector<WarpStep> steps_with_holes(int count, double size) {
    std::mt19937 random(7);
    std::vector<WarpStep> steps;
    const auto number = [&] { return size * (share(random) - 0.5); };
    for (int i = 0; i < count; ++i) {
        BlackHole hole;
        hole.centre = Vec3(number(), number(), number());
        hole.radius = 0.2 * size * share(random) + 1e-9 * size;
        hole.inverse = i % 2 == 1;
        if (i % 9 == 4) hole.repeat = Vec3(size, 0, 0);
        steps.emplace_back(Warp(hole));
        if (i % 11 == 3) steps.emplace_back(Transform::translation(Vec3(0.1 * size, 0, 0)));
    }
    return steps;
}

}  // namespace

TEST_CASE("many black holes lead where they lead one by one", "[pattern]") {
    for (const double size : {1e-20, 1.0, 1e6, 1e30})
        for (const int count : {20, 21, 200}) {
            std::vector<WarpStep> steps = steps_with_holes(count, size);
            const Handle<HoleRows> rows = hole_rows(steps);
            REQUIRE(rows);
            steps.emplace_back(Transform::scaling(Vec3(1.5)));
            std::mt19937 random(3);
            for (int i = 0; i < 500; ++i) {
                Vec3 point;
                for (int axis = 0; axis < 3; ++axis) point[axis] = 2 * size * (share(random) - 0.5);
                REQUIRE(rows->warped(steps, point) == warped(steps, point));
            }
        }
}

TEST_CASE("points on the edge of a black hole, without end and none at all", "[pattern]") {
    std::vector<WarpStep> steps;
    for (int i = 0; i < 20; ++i) {
        BlackHole hole;
        hole.centre = Vec3(1e4 + i, 1. / 3, 0);
        hole.radius = 0.7;
        hole.falloff = 0;
        steps.emplace_back(Warp(hole));
    }
    const Handle<HoleRows> rows = hole_rows(steps);
    REQUIRE(rows);
    const double end = std::nextafter(0.7, 0);
    for (const Vec3& point : {Vec3(1e4 + 3 + end, 1. / 3, 0), Vec3(1e4 + 7, 1. / 3 - 0.7, 0),
                              Vec3(1e4 + 7, 1. / 3 + end, 0), Vec3(HUGE_VAL, 0, 0), Vec3(NAN)})
        CHECK(rows->warped(steps, point) == warped(steps, point));
}

TEST_CASE("few black holes have no rows, and a pattern of many has", "[pattern]") {
    CHECK(!hole_rows(steps_with_holes(8, 1)));
    std::string holes;
    for (int i = 0; i < 20; ++i) holes += " warp { black_hole " + std::to_string(i) + ", 1 }";
    const PatternUse use = pattern_of("bozo" + holes + " scale 2");
    REQUIRE(use.holes);
    CHECK(use.place(Vec3(7.1, 7.3, 7.2)) == warped(use.steps, Vec3(7.1, 7.3, 7.2)));
    CHECK(use.place(Vec3(7.1, 7.3, 7.2)) != Vec3(7.1, 7.3, 7.2) / 2.0);
    CHECK(!pattern_of("bozo warp { black_hole 0, 1 }").holes);
}

}  // namespace candelabra
