// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/compile.h"

#include "support/draw.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace candelabra {

namespace {

/// Convex solids, at most 1 from the origin along each axis.
const std::vector<std::string> convex_solids = {
    "sphere { 0, 1 }",
    "sphere { 0, 1 scale <1, 0.8, 0.9> rotate <20, 30, 40> }",
    "cylinder { -y, y, 1 }",
    "cone { -y, 1, y, 0.3 }",
    "cone { -y, 1, y, 0.3 rotate <20, 30, 40> }",
    "box { -1, 1 rotate <20, 30, 40> }",
    "torus { 0.7, 0.3 }",
    "quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 }",
    "quadric { <1, 2, 1>, <0.5, 0, 0>, <0, 0.2, 0>, -1 }",
    "polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(0, 0, 0): -1 }",
    "intersection { polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, "
    "xyz(0, 0, 0): -1 } box { -2, 2 } }",
    "superellipsoid { <0.6, 0.4> }",
    "superellipsoid { <1, 1> }",
    "lathe { linear_spline 4, <0, -1>, <1, -0.5>, <1, 0.5>, <0, 1> }",
    "lathe { bezier_spline 4, <0, -1>, <1.3, -1>, <1.3, 1>, <0, 1> }",
    "sor { 5, <0, -0.9>, <0.6, -0.8>, <1, 0>, <0.6, 0.8>, <0, 0.9> }",
    "sphere_sweep { linear_spline 2, <-0.3, 0, 0>, 0.5, <0.3, 0, 0>, 0.5 }",
    "blob { threshold 0.5 sphere { 0, 1, 1 } }",
    "isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -1.1, 1.1 } } }",
    "isosurface { function { x*x + y*y + z*z } threshold 0.9 contained_by { sphere { 0, 1.1 } } "
    "rotate 30*y }",
    "intersection { sphere { 0, 1 } sphere { <0.2, 0, 0>, 1 } }",
    "intersection { sphere { 0, 1 } plane { y, 0.5 } cylinder { -2*y, 2*y, 0.9 } }",
    "merge { sphere { 0, 1 } sphere { 0, 0.7 } }",
    "sphere { 0, 1 clipped_by { plane { y, 0.9 } } }",
    "polygon { 5, <-1, 1>, <1, 1>, <1, -1>, <-1, -1>, <-1, 1> rotate <20, 30, 40> }",
    "disc { 0, <1, 2, 3>, 1 }",
    "triangle { <0.3, -1, -1>, <0.2, 1, -1>, <-0.1, 0, 1> }",
    "mesh { triangle { <0.3, -1, -1>, <0.2, 1, -1>, <-0.1, 0, 1> } rotate 10 }",
    "bicubic_patch { type 1 u_steps 3 v_steps 3 <-1,0,-1>, <-0.3,0,-1>, <0.3,0,-1>, <1,0,-1>, "
    "<-1,0,-0.3>, <-0.3,0,-0.3>, <0.3,0,-0.3>, <1,0,-0.3>, <-1,0,0.3>, <-0.3,0,0.3>, <0.3,0,0.3>, "
    "<1,0,0.3>, <-1,0,1>, <-0.3,0,1>, <0.3,0,1>, <1,0,1> rotate 20 }",
};

struct RayStartCounts {
    int rays = 0, surface_again = 0, shadowed = 0;
};

/// Sends rays out from where others meet a convex surface near a point of it.
RayStartCounts leave(const World& world, const Vec3& place, const Vec3& normal, double reach) {
    Draw draw(5);
    RayStartCounts counts;
    for (int i = 0; i < 400; ++i) {
        const Vec3 eye = place + reach * draw.between(0.3, 1) * (normal + 0.9 * draw.direction());
        const Vec3 aim = place + 0.3 * reach * draw.number() * draw.direction();
        Hit hit;
        if (!world.first_hit({eye, unit(aim - eye)}, 0, RayKind::camera, hit)) continue;
        const Vec3 side = dot(hit.normal, eye - aim) > 0 ? hit.normal : -hit.normal;
        const double cosine = std::pow(10, -6 * draw.number());
        const Vec3 along = unit(cross(side, draw.direction()));
        const Ray out{hit.position, unit(along + cosine * side)};
        ++counts.rays;
        Hit again;
        counts.surface_again += world.first_hit(out, hit.tolerance, RayKind::reflected, again);
        counts.shadowed += world.transmittance(out, hit.tolerance, 3 * reach) != Rgb(1);
    }
    return counts;
}

std::string text_of(const Vec3& v) {
    std::ostringstream text;
    text.precision(17);
    text << "<" << v.x << ", " << v.y << ", " << v.z << ">";
    return text.str();
}

Hit first(const World& world, const Vec3& from, const Vec3& to) {
    Hit hit;
    world.first_hit({from, unit(to - from)}, 0, RayKind::camera, hit);
    return hit;
}

}  // namespace

TEST_CASE("the nearest of all kinds of primitives is hit", "[world]") {
    const SharedWorld world = world_of(R"(
        plane { y, -1 }
        sphere { <0, 0, 5>, 1 }
        triangle { <-1, -1, 3>, <3, -1, 3>, <-1, 3, 3> }
        box { <-1, -1, 1>, <1, 1, 2> translate 20*x }
    )");
    CHECK(first(*world, Vec3(0), Vec3(0, 0, 1)).position.z == Approx(3));
    CHECK(first(*world, Vec3(0, 0, 10), Vec3(0)).position.z == Approx(6));
    CHECK(first(*world, Vec3(20, 0, 0), Vec3(20, 0, 1)).position.z == Approx(1));
    CHECK(first(*world, Vec3(0, 5, 0), Vec3(1, -1, 0)).position.y == Approx(-1));
    CHECK(first(*world, Vec3(0), Vec3(0, 1, 0)).primitive == no_primitive);
}

TEST_CASE("of surfaces in one place that of the first object is hit", "[world]") {
    std::string crowd;
    for (int i = 0; i < 60; ++i)
        crowd += "box { <" + std::to_string(i) + ", -3, 0>, <" + std::to_string(i) + ".9, -2, 9> }";
    for (const std::string& others : {std::string(), crowd}) {
        const SharedWorld world = world_of(R"(
            box { <20, 0, 2>, <22, 1, 4> pigment { rgb x } }
            box { <0, 0, 0>, <60, 1, 9> }
            box { <30, 0, 2>, <32, 1, 4> pigment { rgb x } }
        )" + others);
        for (const auto& [x, red] : {std::pair(21.0, true), {31.0, false}}) {
            const Hit hit = first(*world, Vec3(x - 40, 9, 3), Vec3(x, 1, 3));
            CHECK(hit.position.y == Approx(1));
            CHECK((world->material(hit.primitive).texture->pigment.colour.rgb == Rgb(1, 0, 0)) ==
                  red);
        }
    }
}

TEST_CASE("an infinite plane hides walls that lie in it", "[world]") {
    const SharedWorld world = world_of(R"(
        difference { box { 0, <632, 335, 1016> scale 1.001 } box { 0, <632, 335, 1016> } }
        box { 0, <70, 0.3, 33> scale <3, 3.1, 7> translate <100, 0, 300> }
        disc { 0, y, 300 scale 1.7 }
        plane { y, 0 pigment { rgb x } }
    )");
    Draw draw(9);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 eye(draw.between(1, 630), draw.between(100, 330), draw.between(1, 1000));
        const Vec3 aim(draw.between(-900, 900), 0, draw.between(-900, 900));
        // What is in front of the plane stays in front of it.
        const Hit hit = first(*world, eye, aim);
        if (hit.position.y > 1e-9) continue;
        CHECK(world->material(hit.primitive).texture->pigment.colour.rgb == Rgb(1, 0, 0));
    }
    CHECK(first(*world, Vec3(150, 9, 350), Vec3(150, 0, 350)).position.y == Approx(0.93));
}

TEST_CASE("spheres under a similarity stay spheres, others become shapes", "[world]") {
    const SharedWorld round = world_of("sphere { <1, 0, 0>, 1 scale 2 rotate 90*y translate 3*z }");
    REQUIRE(round->geometry.spheres.size() == 1);
    CHECK(length(round->geometry.spheres[0].centre - Vec3(0, 0, 1)) < 1e-12);
    CHECK(round->geometry.spheres[0].radius == Approx(2));

    const SharedWorld oval = world_of("sphere { 0, 1 scale <2, 1, 1> }");
    REQUIRE(oval->geometry.shapes.size() == 1);
    const Hit hit = first(*oval, Vec3(5, 0, 0), Vec3(0));
    CHECK(hit.position.x == Approx(2));
    CHECK(hit.normal.x == Approx(1));
}

TEST_CASE("normals of smooth triangles are interpolated", "[world]") {
    const SharedWorld world =
        world_of("smooth_triangle { <0,0,0>, <-1,0,-1>, <2,0,0>, <1,0,-1>, <1,2,0>, <0,0,-1> }");
    const Hit hit = first(*world, Vec3(1, 0.001, -1), Vec3(1, 0.001, 0));
    CHECK(std::abs(hit.normal.z) == Approx(1));
    CHECK(std::abs(dot(hit.smooth_normal, Vec3(0, 0, -1))) == Approx(1).margin(1e-3));
    CHECK(first(*world, Vec3(0.1, 0.001, -1), Vec3(0.1, 0.001, 0)).smooth_normal.x < -0.5);
}

TEST_CASE("objects can be left out for some rays", "[world]") {
    const SharedWorld world =
        world_of("sphere { <0, 0, 5>, 1 no_image } sphere { <0, 0, 9>, 1 no_reflection }");
    Hit hit;
    const Ray ray{Vec3(0), Vec3(0, 0, 1)};
    REQUIRE(world->first_hit(ray, 0, RayKind::camera, hit));
    CHECK(hit.position.z == Approx(8));
    REQUIRE(world->first_hit(ray, 0, RayKind::reflected, hit));
    CHECK(hit.position.z == Approx(4));
}

TEST_CASE("a walk along a ray meets surfaces in order, until the visit ends it", "[world]") {
    const SharedWorld world = world_of("sphere { 2*z, 1 } sphere { 5*z, 1 } sphere { 8*z, 1 }");
    const Ray ray{Vec3(0), Vec3(0, 0, 1)};
    std::vector<double> distances;
    const auto note = [&](const Hit&, double distance) {
        distances.push_back(distance);
        return distances.size() < 4;
    };
    CHECK_FALSE(world->along(ray, 1e-9, RayKind::light, note));
    CHECK(distances == std::vector<double>{1, 3, 4, 6});
    distances.clear();
    CHECK(world->along(ray, 6.5, RayKind::light, note));
    CHECK(distances == std::vector<double>{7, 9});
}

TEST_CASE("a visit that raises the tolerance of a hit leaves out what is close behind it",
          "[world]") {
    const SharedWorld world = world_of("sphere { 2*z, 1 } sphere { 5*z, 1 }");
    std::vector<double> distances;
    world->along({Vec3(0), Vec3(0, 0, 1)}, 1e-9, RayKind::light, [&](Hit& hit, double distance) {
        distances.push_back(distance);
        hit.tolerance = 2.5;
        return true;
    });
    CHECK(distances == std::vector<double>{1, 4});
}

TEST_CASE("rays that leave a convex solid of any size do not meet it again", "[world]") {
    const Vec3 from = 5.0 * unit(Vec3(3, 0.7, 1.1));
    for (const std::string& solid : convex_solids)
        for (const double size : {1e-3, 1.0, 3e3, 1e4, 1e5, 1e6, 1e9}) {
            INFO(solid << " scaled by " << size);
            const std::string scaled =
                "union { object { " + solid + " scale " + std::to_string(size) + " } translate ";
            const SharedWorld still = world_of(scaled + "0 }");
            const Hit hit = first(*still, size * from, Vec3(0));
            REQUIRE(hit.primitive != no_primitive);
            const Vec3 normal = dot(hit.normal, from) > 0 ? hit.normal : -hit.normal;
            // Near the origin coordinates are small, and tell nothing of the solid's rounding.
            const SharedWorld moved = world_of(scaled + text_of(-hit.position) + " }");
            for (const double reach : {1e-3 * size, std::min(0.1 * size, 0.1)}) {
                const RayStartCounts counts = leave(*moved, Vec3(0), normal, reach);
                CHECK(counts.rays > 100);
                CHECK(counts.surface_again == 0);
                CHECK(counts.shadowed == 0);
            }
        }
}

TEST_CASE("small solids far away do not meet the rays that leave them", "[world]") {
    const Vec3 from = 5.0 * unit(Vec3(3, 0.7, 1.1));
    for (const std::string& solid : convex_solids)
        for (const double away : {1e3, 1e6}) {
            INFO(solid << " moved by " << away);
            const Vec3 place = away * unit(Vec3(1, 2, -2));
            const SharedWorld world =
                world_of("union { object { " + solid + " } translate " + text_of(place) + " }");
            const Hit hit = first(*world, place + from, place);
            REQUIRE(hit.primitive != no_primitive);
            const Vec3 normal = dot(hit.normal, from) > 0 ? hit.normal : -hit.normal;
            const RayStartCounts counts = leave(*world, hit.position, normal, 0.1);
            CHECK(counts.rays > 100);
            CHECK(counts.surface_again == 0);
            CHECK(counts.shadowed == 0);
        }
}

TEST_CASE("rays into a large ball meet its other side", "[world]") {
    for (const double size : {1.0, 3e3, 1e6, 1e9}) {
        const SharedWorld world = world_of("sphere { " + std::to_string(-size) + "*y, " +
                                           std::to_string(size) + " pigment { rgbt 1 } }");
        Draw draw(6);
        for (int i = 0; i < 300; ++i) {
            const double cosine = std::pow(10, -3 * draw.number());
            const Vec3 eye(0.1 * draw.number(), 0.01 + 0.1 * draw.number(), 0);
            Hit hit, other;
            REQUIRE(world->first_hit({eye, unit(Vec3(draw.number(), -1, draw.number()))}, 0,
                                     RayKind::camera, hit));
            const Ray in{hit.position,
                         unit(unit(cross(hit.normal, draw.direction())) - cosine * hit.normal)};
            REQUIRE(world->first_hit(in, hit.tolerance, RayKind::camera, other));
            const double chord = -2 * size * dot(in.direction, hit.normal);
            CHECK(length(other.position - hit.position) == Approx(chord).epsilon(1e-6));
            CHECK(world->transmittance(in, hit.tolerance, 0.5 * chord) == Rgb(1));
        }
    }
}

}  // namespace candelabra
