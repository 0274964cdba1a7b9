// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/transform.h"

#include "support/axes.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Maps of every kind, alone and combined.
std::vector<Transform> maps() {
    const Transform turn = Transform::rotation(Vec3(10, 20, 30)),
                    move = Transform::translation(Vec3(1, -2, 3));
    const Transform stretch = Transform::scaling(Vec3(2, -3, 0.5));
    const Transform shear(Affine{{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 10)}, Vec3(11, 12, 13)});
    return {Transform(),
            turn,
            move,
            stretch,
            shear,
            turn.then(move).then(stretch),
            shear.then(turn),
            stretch.inverse()};
}

}  // namespace

TEST_CASE("rotations turn in the left-handed sense, about x, then y, then z", "[base]") {
    const std::vector<std::pair<Vec3, std::pair<Vec3, Vec3>>> table = {
        {90.0 * y, {x, -z}},  {90.0 * x, {y, z}},   {90.0 * z, {x, y}},
        {180.0 * z, {x, -x}}, {-270.0 * z, {x, y}}, {450.0 * y, {x, -z}},
    };
    for (const auto& [degrees, images] : table)
        CHECK(Transform::rotation(degrees).point(images.first) == images.second);
    const Vec3 turned = Transform::rotation(Vec3(10, 20, 30)).point(Vec3(1, 2, 3));
    CHECK(length(turned - Vec3(1.0674, 2.2891, 2.7606)) < 1e-4);
    const Transform steps = Transform::rotation(10.0 * x)
                                .then(Transform::rotation(20.0 * y))
                                .then(Transform::rotation(30.0 * z));
    CHECK(length(steps.point(Vec3(1, 2, 3)) - turned) < 1e-14);
}

TEST_CASE("rotations about an axis agree with those about x, y and z", "[base]") {
    for (const double degrees : {90.0, 33.0, -120.0}) {
        const Vec3 p(1, 2, 3);
        CHECK(length(Transform::rotation(3.0 * x, degrees).point(p) -
                     Transform::rotation(degrees * x).point(p)) < 1e-14);
        CHECK(length(Transform::rotation(y, degrees).point(p) -
                     Transform::rotation(degrees * y).point(p)) < 1e-14);
        CHECK(length(Transform::rotation(-z, -degrees).point(p) -
                     Transform::rotation(degrees * z).point(p)) < 1e-14);
    }
    CHECK(length(Transform::rotation(Vec3(1), 120).point(x) - y) < 1e-15);
}

TEST_CASE("matrices are images of the axes and a translation", "[base]") {
    const Transform m(Affine{{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 10)}, Vec3(11, 12, 13)});
    CHECK(m.point(x) == Vec3(12, 14, 16));
    CHECK(m.point(y) == Vec3(15, 17, 19));
    CHECK(m.point(z) == Vec3(18, 20, 23));
    CHECK(m.direction(z) == Vec3(7, 8, 10));
    CHECK(m.determinant() == Approx(-3));
    CHECK(Transform::scaling(Vec3(-1, 2, 3)).point(Vec3(1)) == Vec3(-1, 2, 3));
}

TEST_CASE("the inverse undoes a map, and what comes next is done next", "[base]") {
    Draw draw(3);
    for (const Transform& m : maps())
        for (int i = 0; i < 20; ++i) {
            const Vec3 p = draw.point(5);
            CHECK(length(m.inverse_point(m.point(p)) - p) < 1e-12);
            CHECK(length(m.inverse().point(m.point(p)) - p) < 1e-12);
            CHECK(length(m.inverse_direction(m.direction(p)) - p) < 1e-12);
            for (const Transform& next : maps())
                CHECK(length(m.then(next).point(p) - next.point(m.point(p))) < 1e-10);
            const Ray ray{p, draw.direction()}, back = m.inverse_ray(ray);
            CHECK(length(m.point(back.at(2)) - ray.at(2)) < 1e-12);
        }
}

TEST_CASE("normals stay perpendicular to what they were perpendicular to", "[base]") {
    Draw draw(4);
    for (const Transform& m : maps())
        for (int i = 0; i < 20; ++i) {
            const Vec3 normal = draw.direction();
            const auto [along, other] = perpendiculars(normal);
            CHECK(std::abs(dot(unit(m.normal(normal)), unit(m.direction(along)))) < 1e-14);
            CHECK(dot(m.normal(normal), m.direction(normal)) == Approx(1));
        }
}

TEST_CASE("the box of an image is the smallest around the images of the corners", "[base]") {
    const Box box{Vec3(-1, 2, 3), Vec3(2, 2, 5)};
    for (const Transform& m : maps()) {
        Box corners;
        for (int i = 0; i < 8; ++i)
            corners = join(corners, m.point(Vec3(i & 1 ? box.low.x : box.high.x,
                                                 i & 2 ? box.low.y : box.high.y,
                                                 i & 4 ? box.low.z : box.high.z)));
        const Box image = m.box(box);
        CHECK(length(image.low - corners.low) < 1e-12);
        CHECK(length(image.high - corners.high) < 1e-12);
        CHECK(m.box(Box{}).empty());
        CHECK_FALSE(finite(m.box(Box{Vec3(-INFINITY), Vec3(INFINITY)})));
    }
}

TEST_CASE("similarities know their scale", "[base]") {
    const Transform turn = Transform::rotation(Vec3(10, 20, 30));
    const std::vector<std::pair<Transform, double>> table = {
        {Transform(), 1},
        {Transform::scaling(Vec3(3)), 3},
        {turn.then(Transform::scaling(Vec3(3))).then(turn).then(Transform::translation(Vec3(5))),
         3},
        {Transform::scaling(Vec3(-2, 2, 2)), 2},
        {Transform::scaling(Vec3(1, 1, 1.0001)), 0},
        {Transform(Affine{{x, y, Vec3(0.001, 0, 1)}, Vec3(0)}), 0},
    };
    for (const auto& [map, scale] : table) CHECK(map.uniform_scale() == Approx(scale));
}

}  // namespace candelabra
