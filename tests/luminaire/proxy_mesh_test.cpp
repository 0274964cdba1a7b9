// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/proxy_mesh.h"

#include "shape/tessellation.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The mean of 1 over the density is the solid angle that the triangles fill, where each pair of
/// sides counts once: compares it with evenly drawn directions.
void check_density(const ProxyMesh& proxy, const Vec3& from, Draw& draw) {
    double by_points = 0, by_directions = 0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const Vec3 p = proxy.point({draw.number(), draw.number()});
        const double density = proxy.density(from, unit(p - from));
        if (density > 0) by_points += 1 / density / count;
        by_directions += (proxy.density(from, draw.direction()) > 0) * 4 * std::numbers::pi / count;
    }
    CHECK(by_points == Approx(by_directions).epsilon(0.05));
}

}  // namespace

TEST_CASE("a proxy mesh's density is that of its points", "[luminaire]") {
    const ProxyMesh proxy(tessellation(built(Torus{1, 0.3}), 8));
    Draw draw(1);
    const Vec3 from(0.5, 2, 0.3);
    check_density(proxy, from, draw);
}

TEST_CASE("a proxy mesh's points lie evenly on its triangles", "[luminaire]") {
    const ProxyMesh proxy(tessellation(built(Cuboid{Vec3(0), Vec3(1, 1, 3)}), 8));
    Draw draw(2);
    int on_ends = 0;
    for (int i = 0; i < 14000; ++i) {
        const Vec3 p = proxy.point({draw.number(), draw.number()});
        on_ends += p.z < 1e-9 || p.z > 3 - 1e-9;
    }
    CHECK(on_ends == Approx(2000).epsilon(0.1));  // 2 of 14
}

TEST_CASE("a proxy mesh looks where it is told that the surface is bright", "[luminaire]") {
    const Mesh mesh = tessellation(built(Sphere{Vec3(0), 1}), 16);
    std::vector<double> luminance;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        luminance.push_back(face(mesh, i).corners[0].x > 0.5 ? 8 : 1);
    const ProxyMesh proxy(mesh, luminance);
    Draw draw(3);
    const Vec3 from(0.5, 2, 0.3);
    check_density(proxy, from, draw);
    int bright = 0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) bright += proxy.point({draw.number(), draw.number()}).x > 0.5;
    // A quarter of the sphere has eight times the luminance of the rest.
    CHECK(bright == Approx(count * 8.0 / 11).epsilon(0.08));
}

TEST_CASE("a proxy mesh in another place has the points and the density of that place",
          "[luminaire]") {
    const Mesh mesh = tessellation(built(Torus{1, 0.3}), 8);
    const auto place = make_handle<Transform>(Transform::scaling({2, 0.5, 1})
                                                  .then(Transform::rotation({20, 30, 40}))
                                                  .then(Transform::translation({1, 2, 3})));
    const ProxyMesh placed(ProxyMesh(mesh), place);
    Draw draw(4);
    const Vec3 from = place->point(Vec3(0.5, 3, 0.3));
    check_density(placed, from, draw);
}

}  // namespace candelabra
