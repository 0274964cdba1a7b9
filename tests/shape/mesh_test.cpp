// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"
#include "support/line_parts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The cube from -1 to 1, with two outward triangles on each side.
Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(Vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - Vec3(1));
    mesh.faces = {{0, 2, 4}, {4, 2, 6}, {1, 5, 3}, {3, 5, 7}, {0, 4, 1}, {1, 4, 5},
                  {2, 3, 6}, {6, 3, 7}, {0, 1, 2}, {2, 1, 3}, {4, 6, 5}, {5, 6, 7}};
    mesh.inside_vector = y;
    return mesh;
}

Mesh corner_mesh() {
    Mesh mesh;
    mesh.vertices = {o, x, y, z};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

}  // namespace

TEST_CASE("rays cross a mesh where they should", "[shape]") {
    CHECK(answers(build(corner_mesh()), {{Vec3(0.2, 0.2, -5), z}, {{5, -z, true}}}));
    CHECK(answers(build(corner_mesh()), {{Vec3(-5, 0.2, 0.2), 2.0 * x}, {{2.5, -x, true}}}));
    const Vec3 a(0.3, 0.2, -5);
    CHECK(answers(build(cube()), {{a, z}, {{4, -z, true}, {6, z, false}}}));
    CHECK(answers(build(cube()), {{Vec3(0, 0, -5), z}, {{4, -z, true}, {6, z, false}}}));
    CHECK(answers(build(cube()), {{Vec3(-5, 0, 0), x}, {{4, -x, true}, {6, x, false}}}));
    CHECK(answers(build(cube()), {{Vec3(0, 5, 0), -y}, {{4, y, true}, {6, -y, false}}}));
    CHECK(answers(build(Mesh{}), {{a, z}, {}}));
}

TEST_CASE("normals of a mesh come from vertices, from normal_indices, or from the face",
          "[shape]") {
    Mesh mesh;
    mesh.vertices = {o, x, y};
    mesh.faces = {{0, 1, 2}};
    const Ray ray{Vec3(0.2, 0.3, -5), z};
    CHECK(answers(build(mesh), {ray, {{5, -z, true}}}));
    mesh.normals = {-z, Vec3(1, 0, -1), Vec3(0, 1, -1)};
    const Vec3 blended = unit(0.5 * -z + 0.2 * unit(Vec3(1, 0, -1)) + 0.3 * unit(Vec3(0, 1, -1)));
    CHECK(answers(build(mesh), {ray, {{5, blended, true}}}));
    mesh.normal_faces = {{1, 1, 2}};
    const Vec3 indexed = unit(0.7 * unit(Vec3(1, 0, -1)) + 0.3 * unit(Vec3(0, 1, -1)));
    CHECK(answers(build(mesh), {ray, {{5, indexed, true}}}));
    mesh.normals[1] = o;
    mesh.normal_faces = {{1, 1, 0}};
    CHECK(answers(build(mesh), {ray, {{5, -z, true}}}));
    mesh.normal_faces = {{0, 1, 2}};
    CHECK(face(mesh, 0).smooth);
    // As in POV-Ray, three equal normals leave a face flat.
    mesh.normal_faces = {{2, 2, 2}};
    CHECK(answers(build(mesh), {ray, {{5, -z, true}}}));
    CHECK_FALSE(face(mesh, 0).smooth);

    mesh.faces.push_back({0, 2, 1});
    CHECK(problem(mesh) == "");
    CHECK_FALSE(face(mesh, 1).smooth);
    CHECK(face(mesh, 1).normals[2] == z);
}

TEST_CASE("faces without area are not met", "[shape]") {
    Mesh mesh;
    mesh.vertices = {o, x, 2.0 * x};
    mesh.normals = {z, z, z};
    mesh.faces = {{0, 1, 2}, {1, 1, 1}};
    CHECK(problem(mesh) == "");
    CHECK(answers(build(mesh), {{Vec3(0.5, 0, -5), z}, {}}));
    CHECK(answers(build(mesh), {{Vec3(1, 0, -5), z}, {}}));
}

TEST_CASE("a part of the line of a ray meets what the whole of it meets", "[shape]") {
    Draw draw(12);
    Mesh cloud;  // of intersecting triangles that share corners
    for (int i = 0; i < 300; ++i) cloud.vertices.push_back(draw.point(3));
    for (int i = 0; i < 298; ++i) cloud.faces.push_back({i, i + 1, i + 2});
    for (const Mesh& mesh : {cube(), cloud}) {
        const BuiltShape shape = Shared<BuiltMesh>(build(mesh));
        for (int i = 0; i < 2000; ++i) {
            const double some = draw.between(-3, 3);
            CHECK(agree_in({some, some + draw.between(0, 4)}, shape,
                           {draw.point(3), draw.direction()}));
        }
    }
}

TEST_CASE("the inside of a closed mesh is found by counting, also through edges and corners",
          "[shape]") {
    Mesh mesh = cube();
    Draw draw(7);
    for (const Vec3& vector :
         {y, Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(0, 0, -3), Vec3(0.3, 0.1, 0.7)}) {
        mesh.inside_vector = vector;
        const BuiltMesh built = build(mesh);
        CHECK(inside(built, o));
        CHECK(inside(built, Vec3(0.5, 0, 0.5)));
        CHECK_FALSE(inside(built, -2.0 * vector));
        for (int i = 0; i < 200; ++i) {
            const Vec3 p = draw.point(2);
            CHECK(inside(built, p) == (max_abs_component(p) < 1));
        }
    }
    mesh.inside_vector = o;
    CHECK_FALSE(inside(build(mesh), o));
    mesh.inside_vector.reset();
    CHECK_FALSE(inside(build(mesh), o));
}

TEST_CASE("bounds of a mesh hold its faces", "[shape]") {
    Mesh mesh = corner_mesh();
    mesh.vertices.push_back(Vec3(100));
    CHECK(bounds(build(mesh)).low == o);
    CHECK(bounds(build(mesh)).high == Vec3(1));
}

TEST_CASE("what can be wrong with a mesh is said", "[shape]") {
    const auto with = [](auto change) {
        Mesh mesh = corner_mesh();
        change(mesh);
        return problem(mesh);
    };
    CHECK(problem(cube()) == "");
    CHECK(problem(Mesh{}) == "a `mesh2` needs `vertex_vectors`");
    CHECK(with([](Mesh& m) { m.faces.clear(); }) ==
          "a `mesh2` needs at least one face in `face_indices`");
    CHECK(with([](Mesh& m) {
              m.faces[1] = {0, 4, 1};
          }) ==
          "entry 1 of `face_indices` names vertex 4, but there are 4 vertices, counted from 0");
    CHECK(with([](Mesh& m) {
              m.faces[0] = {0, 1, -1};
          }) ==
          "entry 0 of `face_indices` names vertex -1, but there are 4 vertices, counted from 0");
    CHECK(with([](Mesh& m) { m.normals = {z}; }) ==
          "a `mesh2` with 1 normal for 4 vertices needs `normal_indices`");
    CHECK(with([](Mesh& m) {
              m.normal_faces = {{0, 0, 0}};
          }) ==
          "entry 0 of `normal_indices` names normal 0, but there are no normals, counted from 0");
    CHECK(with([](Mesh& m) {
              m.normals = {z}, m.normal_faces = {{0, 0, 0}, {0, 0, 1}};
          }) ==
          "entry 1 of `normal_indices` names normal 1, but there is 1 normal, counted from 0");
    CHECK(with([](Mesh& m) {
              m.normals = {z}, m.normal_faces = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
          }) == "`normal_indices` has 3 entries, but there are only 2 faces");
}

TEST_CASE("a crossing names the face, and u and v of corners come from the lists", "[shape]") {
    Mesh mesh = corner_mesh();
    CHECK(hits(build(mesh), {Vec3(-5, 0.2, 0.2), x}).at(0).part == 1);
    CHECK(face_uvs(mesh, 1)[2] == Vec2(0));
    mesh.uvs = {Vec2(0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)};
    CHECK(face_uvs(mesh, 1) == std::array{Vec2(0), Vec2(0, 1), Vec2(1, 1)});
    mesh.uv_faces = {{0, 0, 0}, {3, 2, 1}};
    CHECK(face_uvs(mesh, 1) == std::array{Vec2(1, 1), Vec2(0, 1), Vec2(1, 0)});
    mesh.uv_faces.clear();
    mesh.uvs.resize(1, Vec2(0));
    CHECK(face_uvs(mesh, 0)[1] == Vec2(0));
}

}  // namespace candelabra
