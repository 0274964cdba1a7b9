// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/mesh_camera.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Faces in a row along x, right triangles with legs of length 3; u and v are the corners'
/// coordinates over 9.
CameraMesh row_of(int count) {
    std::vector<CameraFace> faces;
    for (int i = 0; i < count; ++i) {
        CameraFace face;
        face.corners = {Vec3(3 * i, 0, 0), Vec3(3 * i, 3, 0), Vec3(3 * i + 3, 0, 0)};
        face.normals = {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
        for (std::size_t k = 0; k < 3; ++k)
            face.uvs[k] = Vec2(face.corners[k].x, face.corners[k].y) / 9.0;
        faces.push_back(face);
    }
    return {make_handle<std::vector<CameraFace>>(std::move(faces)), Transform()};
}

MeshRays of(int rays, int distribution, std::vector<CameraMesh> meshes) {
    MeshRays result;
    result.rays = rays;
    result.distribution = distribution;
    result.meshes = std::move(meshes);
    return result;
}

Ray ray_at(const MeshLens& lens, int x, std::uint32_t number = 0) {
    return lens.ray({x, 0, 3, 1, number, (x + 0.5) / 3, 0.1});
}

bool close(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-12; }

}  // namespace

TEST_CASE("rays start in the middle of faces and go along their normals", "[camera]") {
    const MeshLens ahead(of(1, 0, {row_of(2)}), -0.5, false);
    const Ray ray = ray_at(ahead, 1);
    // As in POV-Ray 3.7: the first two sides of this face turn to the right as seen from -z.
    CHECK(close(ray.direction, Vec3(0, 0, 1)));
    CHECK(close(ray.origin, Vec3(4, 1, -0.5)));
    CHECK(ray_at(ahead, 2).direction == Vec3(0));
    const MeshLens back(of(1, 0, {row_of(2)}), -0.5, true);
    CHECK(close(ray_at(back, 1).direction, Vec3(0, 0, -1)));
    CHECK(close(ray_at(back, 1).origin, Vec3(4, 1, -0.5)));
}

TEST_CASE("distributions choose among meshes", "[camera]") {
    CameraMesh other = row_of(3);
    other.transform = Transform::translation(Vec3(0, 10, 0));
    const MeshLens turns(of(2, 0, {row_of(3), other}), 0, false);
    CHECK(ray_at(turns, 1, 0).origin.y == Approx(1));
    CHECK(ray_at(turns, 1, 1).origin.y == Approx(11));
    const MeshLens together(of(2, 1, {row_of(2), other}), 0, false);
    CHECK(close(ray_at(together, 2, 0).origin, Vec3(1, 11, 0)));
    CHECK(close(ray_at(together, 1, 1).origin, ray_at(together, 1, 0).origin));
    const MeshLens beside(of(1, 2, {row_of(3), other, row_of(1)}), 0, false);
    CHECK(close(ray_at(beside, 1).origin, Vec3(1, 11, 0)));
}

TEST_CASE("distribution 3 finds the face by u and v", "[camera]") {
    MeshRays rays = of(1, 3, {row_of(3)});
    const MeshLens flat(rays, 0, false);
    const Ray ray = flat.ray({0, 0, 9, 9, 0, 4.0 / 9, 1.0 / 9});
    CHECK(close(ray.origin, Vec3(4, 1, 0)));
    CHECK(flat.ray({0, 0, 9, 9, 0, 5.5 / 9, 2.0 / 9}).direction == Vec3(0));
    CHECK(flat.ray({0, 0, 9, 9, 0, 0.5, 0.9}).direction == Vec3(0));
    rays.smooth = true;
    rays.meshes[0].faces.edit()[1].normals = {Vec3(0, 0, -1), Vec3(0, 0, -1), Vec3(0, 0, -1)};
    CHECK(close(MeshLens(rays, 0, false).ray({0, 0, 9, 9, 0, 4.0 / 9, 1.0 / 9}).direction,
                Vec3(0, 0, -1)));
}

}  // namespace candelabra
