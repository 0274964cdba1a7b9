// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/height_field.h"

#include "support/draw.h"
#include "support/line_parts.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

TEST_CASE("a landscape is met where its triangles are", "[shape]") {
    Draw draw(4);
    HeightField field;
    field.grid = make_handle<HeightGrid>(HeightGrid{150, 71, {}});
    const HeightGrid& grid = *field.grid;
    Mesh mesh;
    for (int z = 0; z < grid.height; ++z)
        for (int x = 0; x < grid.width; ++x) {
            const double hill = 0.5 + 0.3 * std::sin(x * 0.1) * std::cos(z * 0.15);
            const auto value = static_cast<std::uint16_t>(65536 * (hill + draw.between(0, 0.1)));
            field.grid.edit().values.push_back(value);
            mesh.vertices.push_back(
                Vec3(x / (grid.width - 1.0), value / 65536.0, z / (grid.height - 1.0)));
            if (x == 0 || z == 0) continue;
            const auto corner = static_cast<int>(mesh.vertices.size()) - 1;
            const int left = corner - 1, near = corner - grid.width;
            mesh.faces.push_back({near - 1, near, left});
            mesh.faces.push_back({corner, left, near});
        }
    const BuiltHeightField land = build(field);
    const BuiltMesh triangles = build(mesh);
    const BuiltShape shape = Shared<BuiltHeightField>(land);
    std::size_t met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from = 0.5 * (draw.point() + Vec3(1));
        const Ray ray{from, unit(draw.direction() * Vec3(1, i % 3 ? 0.2 : 1, 1))};
        const auto found = hits(land, ray), expected = hits(triangles, ray);
        met += found.size();
        REQUIRE(found.size() == expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            CHECK(found[k].t == Approx(expected[k].t).margin(1e-6));
        const double some = draw.between(-1, 1);
        CHECK(agree_in({some, some + draw.between(0, 2)}, shape, ray));
    }
    CHECK(met > 2000);
}

TEST_CASE("a height field needs heights", "[shape]") {
    CHECK(problem(HeightField()) == "a `height_field` needs a picture or a function");
}

}  // namespace candelabra
