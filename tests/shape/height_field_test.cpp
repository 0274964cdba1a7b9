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

TEST_CASE("a smooth height field has POV-Ray's normals", "[shape]") {
    HeightField field;
    field.smooth = true;
    field.grid = make_handle<HeightGrid>(HeightGrid{4, 4, {}});
    for (const int byte : {10, 60, 30, 90, 0, 120, 40, 70, 50, 20, 80, 10, 30, 30, 100, 60})
        field.grid.edit().values.push_back(static_cast<std::uint16_t>(257 * byte));
    const BuiltHeightField built = build(field);
    // Measured from POV-Ray 3.7.
    for (const auto& [x, z, normal] : {std::tuple(0.3334, 0.3334, Vec3(-0.0849, 0.9864, 0.1407)),
                                       std::tuple(0.5, 0.4, Vec3(-0.0155, 0.9975, -0.0697)),
                                       std::tuple(0.2, 0.7, Vec3(0.0920, 0.9903, 0.1042)),
                                       std::tuple(0.9, 0.55, Vec3(0.3672, 0.9295, 0.0345))}) {
        const auto found = hits(built, {Vec3(x, 2, z), down});
        REQUIRE(found.size() == 1);
        CHECK(max_abs_component(found[0].normal - normal) < 0.005);
    }
}

TEST_CASE("a height field needs heights", "[shape]") {
    CHECK(problem(HeightField()) == "a `height_field` needs a picture or a function");
}
