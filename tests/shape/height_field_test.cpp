// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/height_field.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace {

const Vec3 down(0, -1, 0);

HeightField slope() {
    HeightField field;
    field.grid = make_handle<HeightGrid>(HeightGrid{2, 2, {0, 32768, 0, 32768}});
    return field;
}

}  // namespace

TEST_CASE("a height field is met at its heights", "[shape]") {
    const BuiltHeightField field = build(slope());
    CHECK(answers(field, {{Vec3(0.5, 2, 0.3), down}, {{1.75, unit(Vec3(-0.5, 1, 0)), true}}}));
    CHECK(hits(field, {Vec3(1.5, 2, 0.3), down}).empty());
    CHECK(inside(field, Vec3(0.5, 0.2, 0.5)));
    CHECK(inside(field, Vec3(0.5, -3, 0.5)));
    CHECK_FALSE(inside(field, Vec3(0.5, 0.3, 0.5)));
}

TEST_CASE("below the water a height field has no surface", "[shape]") {
    HeightField flooded = slope();
    flooded.water_level = 0.3;
    const BuiltHeightField field = build(flooded);
    CHECK(hits(field, {Vec3(0.5, 2, 0.3), down}).empty());
    CHECK(hits(field, {Vec3(0.8, 2, 0.3), down}).size() == 1);
    CHECK(inside(field, Vec3(0.1, 0.25, 0.5)));
}

TEST_CASE("a height field needs heights", "[shape]") {
    CHECK(problem(HeightField()) == "a `height_field` needs a picture or a function");
}
