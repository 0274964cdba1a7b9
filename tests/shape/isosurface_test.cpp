// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/isosurface.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"
#include "support/line_parts.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// The function y as C++ code.
Isosurface ground() {
    Isosurface surface;
    surface.function = make_handle<Formula>(3, 1, [](const double* p, double* value) {
        *value = p[1];
        return true;
    });
    return surface;
}

}  // namespace

TEST_CASE("an isosurface is closed by its container, unless it is open", "[shape]") {
    Isosurface surface = ground();
    CHECK(answers(build(surface), {{Vec3(0, -0.5, -5), z}, {{4, -z, true}, {6, z, false}}}));
    CHECK(answers(build(surface), {{Vec3(0.1, 5, 0), -y}, {{5, y, true}, {6, -y, false}}}));
    CHECK(inside(build(surface), Vec3(0, -0.5, 0)));
    CHECK_FALSE(inside(build(surface), Vec3(0, -1.5, 0)));
    surface.open = true;
    CHECK(hits(build(surface), {Vec3(0, -0.5, -5), z}).empty());
    CHECK(answers(build(surface), {{Vec3(0.1, 5, 0), -y}, {{5, y, true}}}));
    CHECK(answers(build(surface), {{Vec3(0.1, -5, 0), y}, {{5, y, false}}}));
}

TEST_CASE("parts of rays meet of an isosurface what they do as wholes", "[shape]") {
    Isosurface surface;
    surface.function = make_handle<Formula>(3, 1, [](const double* p, double* value) {
        *value = std::sin(7 * p[0]) + std::sin(8 * p[1]) + p[2];
        return true;
    });
    surface.max_gradient = 12;
    const BuiltIsosurface built = build(surface);
    const BuiltShape shape = Shared<BuiltIsosurface>(built);
    Draw draw(3);
    std::size_t met = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 from = draw.point(2);
        const Ray ray{from, draw.between(0.2, 5) * (draw.point(1) - from)};
        const double some = draw.between(0, 2);
        CHECK(agree_in({some, some + draw.between(0, 2)}, shape, ray));
        met += hits(built, ray).size();
    }
    CHECK(met > 300);
}

TEST_CASE("with a polarity above 0 an isosurface is inside where its function is higher",
          "[shape]") {
    Isosurface surface = ground();
    surface.polarity = 1;
    CHECK(answers(build(surface), {{Vec3(0, 0.5, -5), z}, {{4, -z, true}, {6, z, false}}}));
    CHECK(answers(build(surface), {{Vec3(0.1, -5, 0), y}, {{5, -y, true}, {6, y, false}}}));
    CHECK(inside(build(surface), Vec3(0, 0.5, 0)));
    CHECK_FALSE(inside(build(surface), Vec3(0, -0.5, 0)));
}

TEST_CASE("what is wrong with an isosurface", "[shape]") {
    CHECK(problem(Isosurface()) == "an `isosurface` needs a function");
    Isosurface surface = ground();
    surface.function = make_handle<Formula>(2, 1, [](const double*, double*) { return true; });
    CHECK(problem(surface) ==
          "the function of an `isosurface` has three parameters, but this one has 2");
}

TEST_CASE("in a container that is flat there is nothing to see", "[shape]") {
    Isosurface surface = ground();
    surface.containers = {{{}, {}}, {{{Vec3(-1, 0, -1), Vec3(1, 0, 1)}}, {}}};
    CHECK(problem(surface).empty());
    CHECK(hits(build(surface), {Vec3(0, 2, 0), Vec3(0, -1, 0)}).empty());
}

}  // namespace candelabra
