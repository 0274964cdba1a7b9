// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/tessellation.h"

#include "shape/triangle.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

#include <map>

namespace candelabra {

namespace {

/// Six times the volume, from the faces; its sign shows that they face outward.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        sum += dot(a, cross(b, c)) / 6;
    }
    return sum;
}

/// Whether each edge has exactly one face on each side.
bool closed(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const Face& each : mesh.faces)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{each[i], each[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (count != 1 || back == edges.end() || back->second != 1) return false;
    }
    return !mesh.faces.empty();
}

struct SolidCase {
    const char* name;
    Shape shape;
    double volume, tolerance;
};

std::vector<SolidCase> solids() {
    using std::numbers::pi;
    Blob blob;
    blob.spheres.push_back({Vec3(0), 1, 1, {}, -1});
    blob.threshold = 0.25;  // (1 - r^2)^2 = 1/4 at r^2 = 1/2
    Prism prism;
    prism.height2 = 2;
    prism.points = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    return {{"sphere", Sphere{Vec3(1, 2, 3), 2}, 4 * pi / 3 * 8, 0.005},
            {"box", Cuboid{Vec3(0), Vec3(1, 2, 3)}, 6, 1e-12},
            {"cylinder", Cylinder{Vec3(0), Vec3(1, 1, 0), 1, false}, pi * std::sqrt(2), 0.005},
            {"cone", Cone{Vec3(0), 1, Vec3(0, 0, 3), 0, false}, pi, 0.005},
            {"frustum", Cone{Vec3(0), 1, Vec3(3, 0, 0), 2, false}, 7 * pi, 0.005},
            {"torus", Torus{1, 0.25}, 2 * pi * pi * 0.0625, 0.02},
            {"superellipsoid", Superellipsoid{Vec2(1, 1)}, 4 * pi / 3, 0.01},
            {"ovus", Ovus{1, 0}, 0, -1},
            {"blob", Shared(blob), 4 * pi / 3 * std::sqrt(0.125), 0.02},
            {"prism", Shared(prism), 1, 0.05}};
}

}  // namespace

TEST_CASE("solids become closed surfaces of the same volume", "[shape]") {
    for (const SolidCase& each : solids()) {
        INFO(each.name);
        const Mesh mesh = tessellation(built(each.shape), 48);
        CHECK(closed(mesh));
        if (each.tolerance > 0) CHECK(volume(mesh) == Approx(each.volume).epsilon(each.tolerance));
        CHECK(volume(mesh) > 0);
    }
}

TEST_CASE("corners of a marched surface lie on it", "[shape]") {
    const Superellipsoid shape{Vec2(0.4, 0.6)};
    const Mesh mesh = tessellation(built(shape), 20);
    REQUIRE(mesh.vertices.size() > 1000);
    int off = 0;
    for (const Vec3& v : mesh.vertices) off += inside(shape, 0.99 * v) == inside(shape, 1.01 * v);
    // Vertices are kept a small distance away from the corners of cells.
    CHECK(off < 0.05 * static_cast<double>(mesh.vertices.size()));
}

TEST_CASE("marching closes over whatever is inside", "[shape]") {
    Draw draw(1);
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec4> balls;
        for (int i = 0; i < 4; ++i) balls.emplace_back(draw.point(0.6), draw.between(0.1, 0.4));
        const auto within = [&](const Vec3& p) {
            int count = 0;
            for (const Vec4& ball : balls) count += length(p - Vec3(ball)) < ball.w;
            return count % 2 == 1;
        };
        const Mesh mesh = marched({Vec3(-1), Vec3(1)}, within, 12);
        CHECK(closed(mesh));
        CHECK(volume(mesh) > 0);
    }
    CHECK(marched(
              {Vec3(-1), Vec3(1)}, [](const Vec3&) { return false; }, 8)
              .faces.empty());
}

TEST_CASE("shapes of triangles keep them, and what has no end has none", "[shape]") {
    const Triangle triangle{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    CHECK(tessellation(Shared(triangle), 8).faces.size() == 1);
    CHECK(tessellation(built(Plane{Vec3(0, 1, 0), 0}), 8).faces.empty());
    const Mesh ring = tessellation(built(Disc{Vec3(0), Vec3(0, 0, 1), 2, 1}), 32);
    double area = 0;
    for (std::size_t i = 0; i < ring.faces.size(); ++i) {
        const auto [a, b, c] = face(ring, i).corners;
        area += 0.5 * cross(b - a, c - a).z;
    }
    CHECK(area == Approx(3 * std::numbers::pi).epsilon(0.005));
}

}  // namespace candelabra
