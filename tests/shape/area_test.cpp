// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/area.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

#include <functional>

namespace candelabra {

using std::numbers::pi;

namespace {

/// A bent sheet of areas 3 and 2, with normals that make it look round, and a face without area.
BuiltShape bent_sheet() {
    Mesh mesh;
    mesh.vertices = {o, 2.0 * x, 3.0 * y, 2.0 * z};
    mesh.normals = {-y - z, x - y - z, -z, -y};
    mesh.faces = {{0, 1, 2}, {0, 1, 1}, {0, 3, 1}};
    return Shared<BuiltMesh>(build(mesh));
}

const std::vector<std::pair<BuiltShape, double>> areas = {
    {Sphere{x, 2}, 16 * pi},
    {Cuboid{Vec3(1, 2, 3), Vec3(0, 0, 0)}, 22},
    {Cuboid{Vec3(0), Vec3(2, 3, 0)}, 12},
    {Disc{x, Vec3(1, 2, 3), 2, 0}, 4 * pi},
    {Disc{x, Vec3(1, 2, 3), 2, 1}, 3 * pi},
    {Cylinder{o, Vec3(3, 0, 4), 2, false}, 28 * pi},
    {Cylinder{o, Vec3(3, 0, 4), 2, true}, 20 * pi},
    {Cone{x, 3, x + 4.0 * y, 0, false}, 24 * pi},
    {Cone{x, 0, x + 4.0 * y, 3, true}, 15 * pi},
    {Cone{x, 5, x + 4.0 * y, 2, false}, 64 * pi},
    {Cone{x, 2, x + 5.0 * y, 2, false}, 28 * pi},
    {Shared<Triangle>(Triangle{o, 2.0 * x, 3.0 * y}), 3},
    {Shared<SmoothTriangle>(SmoothTriangle{o, -z, 2.0 * x, -z, 3.0 * y, y - z}), 3},
    {bent_sheet(), 5},
};

/// Maps a point to the number of its region, with each region's share of the area.
struct Regions {
    BuiltShape shape;
    std::vector<double> shares;
    std::function<std::size_t(const Vec3&)> number;
};

std::size_t band(double value, std::initializer_list<double> limits) {
    return static_cast<std::size_t>(
        std::count_if(limits.begin(), limits.end(), [&](double l) { return value >= l; }));
}

/// Which fifth of the turn around the y axis contains the point.
std::size_t sector(const Vec3& p) {
    const double turn = std::atan2(p.z, p.x) / (2 * pi);
    return std::min<std::size_t>(4, static_cast<std::size_t>(5 * (turn < 0 ? turn + 1 : turn)));
}

std::vector<double> fifths(std::initializer_list<double> parts) {
    std::vector<double> shares;
    for (const double part : parts) shares.insert(shares.end(), 5, part / 5);
    return shares;
}

const std::vector<Regions> divided = {
    {Sphere{o, 2}, fifths({0.25, 0.25, 0.25, 0.25}),
     [](const Vec3& p) {
         return 5 * band(p.y, {-1, 0, 1}) + sector(p);
     }},
    {Disc{o, y, 2, 1}, fifths({0.09 / 0.75, 0.11 / 0.75, 0.2425 / 0.75, 0.3075 / 0.75}),
     [](const Vec3& p) {
         return 5 * band(length(p), {std::sqrt(1.36), std::sqrt(1.8), std::sqrt(2.77)}) + sector(p);
     }},
    {Cylinder{o, 3.0 * y, 1, false}, fifths({0.125, 0.25, 0.5, 0.125}),
     [](const Vec3& p) {
         return 5 * (p.y <= 0 ? 0 : p.y >= 3 ? 3 : band(p.y, {1}) + 1) + sector(p);
     }},
    // Slant 5, from radius 5 to 2 over a height of 4: 35 pi on the side, 25 pi and 4 pi on the
    // ends.
    {Cone{o, 5, 4.0 * y, 2, false},
     fifths({25.0 / 64, (5 + 3.5) * 2.5 / 64, (3.5 + 2) * 2.5 / 64, 4.0 / 64}),
     [](const Vec3& p) {
         return 5 * (p.y <= 0 ? 0 : p.y >= 4 ? 3 : band(p.y, {2}) + 1) + sector(p);
     }},
    {Cone{o, 0, y, 1, true}, fifths({0.0625, 0.1875, 0.3125, 0.4375}),
     [](const Vec3& p) {
         return 5 * band(p.y, {0.25, 0.5, 0.75}) + sector(p);
     }},
    {Cuboid{o, Vec3(1, 2, 4)},
     {8. / 112, 8. / 112, 8. / 112, 8. / 112, 8. / 112, 8. / 112, 8. / 112, 8. / 112,
      4. / 112, 4. / 112, 4. / 112, 4. / 112, 4. / 112, 4. / 112, 4. / 112, 4. / 112,
      2. / 112, 2. / 112, 2. / 112, 2. / 112, 2. / 112, 2. / 112, 2. / 112, 2. / 112},
     [](const Vec3& p) {
         const std::size_t i = p.x >= 0.5, j = p.y >= 1, k = p.z >= 2;
         if (p.x == 0 || p.x == 1) return 4 * i + 2 * j + k;
         return p.y == 0 || p.y == 2 ? 8 + 4 * j + 2 * i + k : 16 + 4 * k + 2 * i + j;
     }},
    {Shared<Triangle>(Triangle{o, 2.0 * x, 3.0 * z}), fifths({0.4375, 0.3125, 0.1875, 0.0625}),
     [](const Vec3& p) {
         const double a = p.x / 2, b = p.z / 3, off = 1 - a - b;
         const std::size_t across =
             std::min<std::size_t>(4, static_cast<std::size_t>(5 * a / (a + b)));
         return 5 * band(off, {0.25, 0.5, 0.75}) + across;
     }},
    {bent_sheet(),
     {0.6, 0.3, 0.1},
     [](const Vec3& p) { return p.z == 0 ? 0 : 1 + band(p.z, {1}); }},
};

}  // namespace

TEST_CASE("areas are exact", "[shape]") {
    for (const auto& [shape, expected] : areas) {
        INFO(shape.index());
        CHECK(surface_area(shape) == Approx(expected).epsilon(1e-14));
    }
    CHECK(surface_area(BuiltShape(Plane{})) == 0);
    CHECK(surface_area(build(Mesh{})) == 0);
}

TEST_CASE("sampled points are on the surface, with its normal", "[shape]") {
    Draw draw(8);
    for (const auto& [shape, expected] : areas) {
        INFO(shape.index());
        for (int i = 0; i < 300; ++i) {
            const SurfacePoint s = sample_area(shape, Vec2(draw.number(), draw.number()));
            CHECK(length(s.normal) == Approx(1).epsilon(1e-14));
            // From slightly outside down to the point.
            const std::vector<Crossing> found =
                hits(shape, Ray{s.position + 0.25 * s.normal, -s.normal});
            const auto met = std::find_if(found.begin(), found.end(), [](const Crossing& c) {
                return std::abs(c.t - 0.25) < 1e-13;
            });
            REQUIRE(met != found.end());
            if (!std::holds_alternative<Shared<SmoothTriangle>>(shape) &&
                !std::holds_alternative<Shared<BuiltMesh>>(shape))
                CHECK(length(met->normal - s.normal) < 1e-13);
            CHECK(met->entering);
        }
    }
}

TEST_CASE("the ends of the range of u are on the surface too", "[shape]") {
    const double one = 1 - 0x1p-53;
    for (const auto& [shape, expected] : areas)
        for (const Vec2& u : {Vec2(0, 0), Vec2(one, 0), Vec2(0, one), Vec2(one, one)}) {
            const SurfacePoint s = sample_area(shape, u);
            const Box b = bounds(shape);
            INFO(shape.index());
            CHECK(contains(Box{b.low - Vec3(1e-14), b.high + Vec3(1e-14)}, s.position));
            CHECK(length(s.normal) == Approx(1).epsilon(1e-14));
        }
}

TEST_CASE("points are spread evenly over the area", "[shape]") {
    constexpr int side = 200, count = side * side;
    Draw draw(9);
    for (const Regions& regions : divided) {
        INFO(regions.shape.index());
        std::vector<int> met(regions.shares.size());
        for (int i = 0; i < count; ++i)
            ++met.at(regions.number(
                sample_area(regions.shape, Vec2(draw.number(), draw.number())).position));
        double chi2 = 0, total = 0;
        for (std::size_t i = 0; i < met.size(); ++i) {
            const double expected = count * regions.shares[i];
            chi2 += (met[i] - expected) * (met[i] - expected) / expected;
            total += regions.shares[i];
        }
        CHECK(total == Approx(1).epsilon(1e-14));
        // At most 23 degrees of freedom: chi2 exceeds 50 with a probability below 0.001.
        CHECK(chi2 < 50);
    }
}

}  // namespace candelabra
