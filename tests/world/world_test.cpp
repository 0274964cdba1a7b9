// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/compile.h"

#include "support/draw.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Hit first(const World& world, const Vec3& from, const Vec3& to) {
    Hit hit;
    world.first_hit({from, unit(to - from)}, 0, RayKind::camera, hit);
    return hit;
}

Vec3 between(const World& world, const Vec3& from, const Vec3& to) {
    return world.transmittance({from, unit(to - from)}, 0, length(to - from));
}

}  // namespace

TEST_CASE("the nearest of all kinds of primitives is hit", "[world]") {
    const World world = world_of(R"(
        plane { y, -1 }
        sphere { <0, 0, 5>, 1 }
        triangle { <-1, -1, 3>, <3, -1, 3>, <-1, 3, 3> }
        box { <-1, -1, 1>, <1, 1, 2> translate 20*x }
    )");
    CHECK(first(world, Vec3(0), Vec3(0, 0, 1)).position.z == Approx(3));
    CHECK(first(world, Vec3(0, 0, 10), Vec3(0)).position.z == Approx(6));
    CHECK(first(world, Vec3(20, 0, 0), Vec3(20, 0, 1)).position.z == Approx(1));
    CHECK(first(world, Vec3(0, 5, 0), Vec3(1, -1, 0)).position.y == Approx(-1));
    CHECK(first(world, Vec3(0), Vec3(0, 1, 0)).primitive == no_primitive);
}

TEST_CASE("of surfaces in one place that of the first object is hit", "[world]") {
    std::string crowd;
    for (int i = 0; i < 60; ++i)
        crowd += "box { <" + std::to_string(i) + ", -3, 0>, <" + std::to_string(i) + ".9, -2, 9> }";
    for (const std::string& others : {std::string(), crowd}) {
        const World world = world_of(R"(
            box { <20, 0, 2>, <22, 1, 4> pigment { rgb x } }
            box { <0, 0, 0>, <60, 1, 9> }
            box { <30, 0, 2>, <32, 1, 4> pigment { rgb x } }
        )" + others);
        for (const auto& [x, red] : {std::pair(21.0, true), {31.0, false}}) {
            const Hit hit = first(world, Vec3(x - 40, 9, 3), Vec3(x, 1, 3));
            CHECK(hit.position.y == Approx(1));
            CHECK((world.material(hit.primitive).texture->pigment.colour.rgb == Vec3(1, 0, 0)) ==
                  red);
        }
    }
}

TEST_CASE("spheres under a similarity stay spheres, others become shapes", "[world]") {
    const World round = world_of("sphere { <1, 0, 0>, 1 scale 2 rotate 90*y translate 3*z }");
    REQUIRE(round.geometry.spheres.size() == 1);
    CHECK(length(round.geometry.spheres[0].centre - Vec3(0, 0, 1)) < 1e-12);
    CHECK(round.geometry.spheres[0].radius == Approx(2));

    const World oval = world_of("sphere { 0, 1 scale <2, 1, 1> }");
    REQUIRE(oval.geometry.shapes.size() == 1);
    const Hit hit = first(oval, Vec3(5, 0, 0), Vec3(0));
    CHECK(hit.position.x == Approx(2));
    CHECK(hit.normal.x == Approx(1));
}

TEST_CASE("normals of smooth triangles are interpolated", "[world]") {
    const World world =
        world_of("smooth_triangle { <0,0,0>, <-1,0,-1>, <2,0,0>, <1,0,-1>, <1,2,0>, <0,0,-1> }");
    const Hit hit = first(world, Vec3(1, 0.001, -1), Vec3(1, 0.001, 0));
    CHECK(std::abs(hit.normal.z) == Approx(1));
    CHECK(std::abs(dot(hit.smooth_normal, Vec3(0, 0, -1))) == Approx(1).margin(1e-3));
    CHECK(first(world, Vec3(0.1, 0.001, -1), Vec3(0.1, 0.001, 0)).smooth_normal.x < -0.5);
}

TEST_CASE("light passes through what is clear, and counts each surface once", "[world]") {
    const World world = world_of(R"(
        sphere { <0, 0, 5>, 1 pigment { rgbf <1, 0.5, 0.25, 0.5> } }
        box { <9, -1, 4>, <11, 1, 5> pigment { rgb 1 } }
        box { <-11, -1, 4>, <-9, 1, 5> pigment { rgb 1 } no_shadow }
    )");
    const Vec3 passed = between(world, Vec3(0), Vec3(0, 0, 20));
    CHECK(length(passed - Vec3(0.25, 0.0625, 0.015625)) < 1e-12);
    CHECK(between(world, Vec3(0), Vec3(0, 0, 5)).x == Approx(0.5));
    CHECK(between(world, Vec3(10, 0, 0), Vec3(10, 0, 20)) == Vec3(0));
    CHECK(between(world, Vec3(10, 0, 0), Vec3(10, 0, 4)) == Vec3(1));
    CHECK(between(world, Vec3(-10, 0, 0), Vec3(-10, 0, 20)) == Vec3(1));
}

TEST_CASE("objects can be left out for some rays", "[world]") {
    const World world =
        world_of("sphere { <0, 0, 5>, 1 no_image } sphere { <0, 0, 9>, 1 no_reflection }");
    Hit hit;
    const Ray ray{Vec3(0), Vec3(0, 0, 1)};
    REQUIRE(world.first_hit(ray, 0, RayKind::camera, hit));
    CHECK(hit.position.z == Approx(8));
    REQUIRE(world.first_hit(ray, 0, RayKind::reflected, hit));
    CHECK(hit.position.z == Approx(4));
}

TEST_CASE("a point knows the clear solids that it is in", "[world]") {
    const World world =
        world_of("sphere { 0, 2 pigment { rgbt 1 } } sphere { 0, 3 pigment { rgb 1 } }");
    CHECK(world.containing(Vec3(1, 0, 0)).size() == 1);
    CHECK(world.containing(Vec3(2.5, 0, 0)).empty());
    // With fog, it also finds the others, which keep fog out, unless they are hollow.
    const World foggy = world_of(
        "fog { distance 9 rgb 1 } sphere { 0, 2 hollow } sphere { 0, 3 } sphere { 0, 4 hollow }"
        "union { sphere { 0, 5 } sphere { 9*x, 2 } } difference { sphere { 0, 6 } box { 1, 9 } }");
    CHECK(foggy.containing(Vec3(1, 0, 0)).size() == 3);
    // Rays of a parallel camera begin in many places, so the world has an index. Other cameras are
    // at one place, so the world has none.
    const std::string scene = R"(
        #for (I, 1, 20) sphere { 10*I*x, 3 pigment { rgbt 1 } } #end
        plane { y, -5 pigment { rgbt 1 } } sphere { 0, 3 pigment { rgb 1 } }
        difference { box { -3, 3 } sphere { 0, 3 } pigment { rgbt 1 } }
        sphere { 40*z, 5 inverse pigment { rgbt 1 } } disc { -30*z, y, 5 pigment { rgbt 1 } }
        height_field { function 8, 8 { x*y } scale 9 translate 50*x pigment { rgbt 1 } }
        box { 20, 30 pigment { rgbt 1 } rotate 20 } torus { 9, 2 inverse pigment { rgbt 1 } }
        merge { sphere { -20*x, 3 } box { -24, -20 } inverse pigment { rgbt 1 } })";
    const World parallel = world_of("camera { orthographic location -9*z look_at 0 }" + scene),
                other = world_of("camera { location -9*z look_at 0 }" + scene);
    Draw draw(3);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 point = draw.point(60);
        EnteredSolids found = parallel.containing(point), expected = other.containing(point);
        std::ranges::sort(found);
        std::ranges::sort(expected);
        CAPTURE(point.x, point.y, point.z);
        CHECK(found == expected);
    }
    CHECK(parallel.geometry.clear_solids.finite.size() > 20);
}

TEST_CASE("a ray enters and leaves solids where it passes their surfaces", "[world]") {
    const World world = world_of(
        "sphere { 0, 2 } sphere { x, 2 } union { sphere { 0, 5 } sphere { 9*x, 2 } interior { } }");
    EnteredSolids inside;
    CHECK(world.pass(0, inside) == Passing::enters);
    CHECK(world.pass(1, inside) == Passing::enters);
    CHECK(world.pass(0, inside) == Passing::leaves_outer);
    CHECK(world.pass(1, inside) == Passing::leaves_innermost);
    CHECK(inside.empty());
    // Parts of a union that share an interior are one solid.
    CHECK(world.pass(2, inside) == Passing::enters);
    CHECK(world.pass(3, inside) == Passing::leaves_innermost);
}

TEST_CASE("the background's transparency counts from version 3.7 on", "[world]") {
    const std::string text = "background { rgbft <1, 0.5, 0.2, 0.25, 0.5> }";
    const World now = world_of("#version 3.7; " + text), old = world_of("#version 3.6; " + text);
    CHECK(now.sky_radiance(Vec3(0, 0, 1)) == Vec3(0.5, 0.25, 0.1));
    CHECK(now.sky.background.covering() == Vec3(0.25, 0.125, 0.05));
    CHECK(now.sky.background.mirrored() == Vec3(1, 0.5, 0.2));
    CHECK(old.sky_radiance(Vec3(0, 0, 1)) == Vec3(1, 0.5, 0.2));
}

TEST_CASE("a walk along a ray meets surfaces in order, until the visit ends it", "[world]") {
    const World world = world_of("sphere { 2*z, 1 } sphere { 5*z, 1 } sphere { 8*z, 1 }");
    const Ray ray{Vec3(0), Vec3(0, 0, 1)};
    std::vector<double> distances;
    const auto note = [&](const Hit&, double distance) {
        distances.push_back(distance);
        return distances.size() < 4;
    };
    CHECK_FALSE(world.along(ray, 1e-9, RayKind::light, note));
    CHECK(distances == std::vector<double>{1, 3, 4, 6});
    distances.clear();
    CHECK(world.along(ray, 6.5, RayKind::light, note));
    CHECK(distances == std::vector<double>{7, 9});
}

TEST_CASE("a visit that raises the tolerance of a hit leaves out what is close behind it",
          "[world]") {
    const World world = world_of("sphere { 2*z, 1 } sphere { 5*z, 1 }");
    std::vector<double> distances;
    world.along({Vec3(0), Vec3(0, 0, 1)}, 1e-9, RayKind::light, [&](Hit& hit, double distance) {
        distances.push_back(distance);
        hit.tolerance = 2.5;
        return true;
    });
    CHECK(distances == std::vector<double>{1, 4});
}

}  // namespace candelabra
