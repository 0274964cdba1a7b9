// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/uv.h"
#include "support/axes.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

bool close(const std::optional<Vec2>& found, const Vec2& expected) {
    return found && length(*found - expected) < 1e-9;
}

}  // namespace

TEST_CASE("u goes around a sphere and v from its bottom to its top", "[shape]") {
    const Sphere sphere{Vec3(1), 2};
    const auto at = [&](const Vec3& direction) { return uv(sphere, Vec3(1) + 2.0 * direction, 0); };
    CHECK(close(at(x), {0, 0.5}));
    CHECK(close(at(z), {0.25, 0.5}));
    CHECK(close(at(-x), {0.5, 0.5}));
    CHECK(close(at(-z), {0.75, 0.5}));
    CHECK(close(at(y), {0, 1}));
    CHECK(close(at(-y), {0, 0}));
}

TEST_CASE("the sides of a box lie as a cross", "[shape]") {
    const Cuboid box{o, Vec3(2, 3, 4)};
    const auto middle = [&](const Vec3& p) { return uv(box, p * Vec3(2, 3, 4), 0); };
    CHECK(close(middle({0, .5, .5}), {.125, .5}));
    CHECK(close(middle({.5, .5, 1}), {.375, .5}));
    CHECK(close(middle({1, .5, .5}), {.625, .5}));
    CHECK(close(middle({.5, .5, 0}), {.875, .5}));
    CHECK(close(middle({.5, 1, .5}), {.375, 5 / 6.0}));
    CHECK(close(middle({.5, 0, .5}), {.375, 1 / 6.0}));
    CHECK(close(middle({1, .25, 0}), {.75, 1.25 / 3}));
}

TEST_CASE("u goes around a torus and v around its tube", "[shape]") {
    const Torus torus{3, 1};
    CHECK(close(uv(torus, 4.0 * x, 0), {.5, .5}));
    CHECK(close(uv(torus, 4.0 * z, 0), {.25, .5}));
    CHECK(close(uv(torus, 3.0 * x + y, 0), {.5, .75}));
    CHECK(close(uv(torus, -3.0 * z - y, 0), {.75, .25}));
}

TEST_CASE("v follows the points of a lathe and of a sor", "[shape]") {
    Lathe lathe;
    lathe.points = {{1, 0}, {1, 3}, {2, 3}};
    const BuiltLathe built = build(lathe);
    CHECK(close(uv(built, Vec3(1, 1.5, 0), 0), {0, .25}));
    CHECK(close(uv(built, Vec3(0, 3, 1.5), 0), {.25, .75}));
    Sor sor;
    sor.points = {{1, -1}, {1, 0}, {1, 4}, {1, 5}};
    const BuiltSor vase = build(sor);
    CHECK(close(uv(vase, Vec3(-1, 1, 0), 0), {.5, .25}));
    // On its ends v continues towards the middle.
    CHECK(close(uv(vase, Vec3(.25, 4, 0), 0), {0, 1.75}));
    CHECK(close(uv(vase, Vec3(0, 0, .25), 0), {.25, -.75}));
    // Pieces of different heights have equal parts of v.
    sor.points = {{1, -1}, {1, 0}, {1, 4}, {1, 5}, {1, 6}};
    const BuiltSor tall = build(sor);
    CHECK(close(uv(tall, Vec3(-1, 2, 0), 0), {.5, .25}));
    CHECK(close(uv(tall, Vec3(-1, 4.5, 0), 0), {.5, .75}));
    // Values of POV-Ray 3.7: each piece has an equal part, independent of its height.
    sor.points = {{.3, -1.2}, {.3, -1}, {.9, -.2}, {.4, .8}, {.3, 1}};
    const BuiltSor bottle = build(sor);
    for (const auto& [height, v] : {std::pair{-.975, .01563}, std::pair{-.525, .29688},
                                    std::pair{-.175, .51250}, std::pair{.775, .98750}})
        CHECK(uv(bottle, Vec3(.5, height, 0), 0)->y == Approx(v).margin(1e-4));
}

TEST_CASE("a patch lies between the u and v of its corners", "[shape]") {
    BicubicPatch patch;
    patch.type = 1;
    patch.u_steps = patch.v_steps = 2;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            patch.points.push_back(Vec3(column / 3.0, row / 3.0, 0));
    for (const bool known : {false, true}) {
        const BuiltBicubicPatch built = build(patch);
        Crossings found;
        crossings(built, Ray{Vec3(.3, .6, -1), z}, found);
        REQUIRE(found.size() == 1);
        CHECK(close(uv(built, Vec3(.3, .6, 0), known ? found[0].part : any_part), {.3, .6}));
    }
    patch.uv1 = Vec2(5, 0);
    CHECK(close(uv(build(patch), o, any_part), {5, 0}));
}

TEST_CASE("u and v of meshes are mixed between the corners", "[shape]") {
    Mesh mesh;
    mesh.vertices = {o, x, y, x + y};
    mesh.uvs = {Vec2(0), Vec2(2, 0), Vec2(0, 4), Vec2(2, 4)};
    mesh.faces = {{0, 1, 2}, {1, 3, 2}};
    const BuiltMesh built = build(mesh);
    CHECK(close(uv(built, Vec3(.25, .5, 0), any_part), {.5, 2}));
    CHECK(close(uv(built, Vec3(.75, .5, 0), any_part), {1.5, 2}));
    CHECK(close(uv(built, Vec3(.75, .5, 0), 1), {1.5, 2}));
    CHECK(face_at(built, Vec3(.9, .9, 0)) == 1);
}

TEST_CASE("shapes that nothing is wrapped around have no u and v", "[shape]") {
    CHECK_FALSE(uv(BuiltShape(Plane{}), o, 0));
    CHECK(uv(BuiltShape(Sphere{}), x, 0));
}

}  // namespace candelabra
