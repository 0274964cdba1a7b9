// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that hurt: sizes from 1e-6 to 1e6 in one scene, places far from the origin, rays along
// axes and edges, flat boxes, huge planes beside tiny meshes. The world is held against itself
// without a tree, and surfaces neither shadow themselves nor leak. [.long] does the same with
// millions of rays.
#include "index/tree_builder.h"
#include "support/draw.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The same world, where each ray asks all primitives.
World without_tree(const World& given) {
    World world(given);
    std::vector<Box> boxes(world.geometry.item_count(), Box{Vec3(-1e9), Vec3(1e9)});
    for (const std::uint32_t item : world.geometry.infinite.all) boxes[item] = Box();
    world.geometry.tree = build_tree(boxes, {}, 1);
    return world;
}

struct Case {
    const char* name;
    std::string script;
    Vec3 centre;
    double size;  ///< of what rays are aimed at
};

std::vector<Case> cases() {
    const std::string scales =
        "#declare R = seed(1);\n"
        "#for (I, -60, 60) #local S = pow(10, I/10);\n"
        "sphere { S*<3*rand(R), 3*rand(R), 3*rand(R)>, S }\n"
        "box { S*<-2, 1, 3*rand(R)>, S*<-1, 2, 3.1> rotate 30*z }\n"
        "triangle { S*<3, 0, 1>, S*<4, rand(R), 1>, S*<3, 1, 2> } #end\n";
    const std::string things =
        "#declare R = seed(2);\n"
        "#for (I, 1, 60) sphere { <rand(R), rand(R), rand(R)>, 0.05 }\n"
        "box { <rand(R), rand(R), 0.5>, <rand(R), rand(R), 0.5 + 0.1*rand(R)> }\n"
        "cylinder { <rand(R), 0, rand(R)>, <rand(R), 1, rand(R)>, 0.02 }\n"
        "triangle { <rand(R), 0, rand(R)>, <rand(R), 1, rand(R)>, <rand(R), 1, 0> } #end\n";
    const std::string lattice =
        "#for (I, 0, 3) #for (J, 0, 3) #for (K, 0, 3)\n"
        "box { <I, J, K>, <I + 1, J + 1, K + (mod(I + J + K, 2) ? 1 : 0)> }\n"
        "triangle { <I, J, K>, <I + 1, J, K>, <I, J + 1, K> } #end #end #end\n";
    const std::string beside =
        "plane { y, 0 } box { <-1e6, -2, -1e6>, <1e6, -1, 1e6> }\n"
        "triangle { <-1e6, 1e-3, -1e6>, <1e6, 1e-3, -1e6>, <0, 1e-3, 1e6> }\n"
        "#declare R = seed(3); #for (I, 1, 300)\n"
        "triangle { 0.01*<rand(R), rand(R), rand(R)>, 0.01*<rand(R), rand(R), rand(R)>,\n"
        "0.01*<rand(R), rand(R), rand(R)> } #end\n";
    const auto moved = [&](const char* by) {
        return "union {\n" + things + "translate " + by + " }";
    };
    return {{"all scales", scales, Vec3(0), 3},
            {"the smallest of all scales", scales, Vec3(0), 1e-5},
            {"the largest of all scales", scales, Vec3(0), 3e6},
            {"many things", things, Vec3(0.5), 0.8},
            {"moved by 1e6", moved("<1e6, -1e6, 1e6>"), Vec3(1e6 + .5, -1e6 + .5, 1e6 + .5), 0.8},
            {"a lattice of boxes, some flat", lattice, Vec3(2), 2.5},
            {"a tiny mesh beside a huge plane", beside, Vec3(0.005), 0.01},
            {"coincident", "#for (I, 1, 500) sphere { x, 1 } #end", Vec3(1, 0, 0), 1}};
}

/// Any way across the scene: from near or far, every third along an axis and on the lattice.
Ray aimed(const Case& each, Draw& draw) {
    const Vec3 target = each.centre + each.size * draw.point();
    if (draw.number() < 0.6) {
        const double far = std::pow(10, draw.between(-1, 3));
        const Vec3 from = each.centre + each.size * far * draw.direction();
        return {from, unit(target - from)};
    }
    Vec3 along(0);
    const int axis = static_cast<int>(draw.number() * 3);
    along[axis] = draw.number() < 0.5 ? 1 : -1;
    const double step = each.size / 20;
    const Vec3 grid = each.centre + step * glm::round((target - each.centre) / step);
    return {grid - 3 * each.size * along, along};
}

void agree(const RayIndex& index, std::size_t rays) {
    for (const Case& each : cases()) {
        INFO(each.name);
        const SharedWorld with = world_of(each.script, index);
        const World without = without_tree(*with);
        Draw draw(1);
        std::size_t met = 0, other = 0;
        for (std::size_t i = 0; i < rays; ++i) {
            const Ray ray = aimed(each, draw);
            Hit a, b;
            const bool found = with->first_hit(ray, 0, RayKind::camera, a);
            met += found;
            other +=
                found != without.first_hit(ray, 0, RayKind::camera, b) || a.position != b.position;
            const double far = each.size * std::pow(10, draw.between(-1, 3));
            other += with->transmittance(ray, 0, far) != without.transmittance(ray, 0, far);
        }
        CHECK(other == 0);
        CHECK(met > rays / 50);
    }
}

/// Surfaces of one convex solid: light leaves them to all sides, and none gets in or out.
void keep_tight(std::size_t rays) {
    for (const char* shape :
         {"sphere { 0, 1 ", "box { -1, 1 ", "cylinder { -y, y, 1 ", "cone { -y, 1, y, 0.3 ",
          "superellipsoid { <0.5, 0.5> ", "intersection { box { -1, 1 } sphere { 0, 1.3 } "})
        for (const double size : {1e-6, 1.0, 1e6})
            for (const double off : {0.0, 1e3, 1e6}) {
                // Rays begin 1e-11 of the place's distance away from the surface.
                if (off > 1e7 * size) continue;
                const std::string script = std::string(shape) + "rotate <10, 20, 30> scale " +
                                           std::to_string(size * 1e6) + "/1e6 translate " +
                                           std::to_string(off) + " }";
                INFO(script);
                const SharedWorld world = world_of(script);
                Draw draw(2);
                std::size_t specks = 0, leaks = 0;
                for (std::size_t i = 0; i < rays; ++i) {
                    const Vec3 centre(off), from = centre + 5 * size * draw.direction();
                    const Ray in{from, unit(centre + 0.7 * size * draw.point() - from)};
                    Hit hit;
                    if (!world->first_hit(in, 0, RayKind::camera, hit)) continue;
                    const Vec3 way = draw.direction();
                    const double facing = dot(way, hit.normal);
                    if (std::abs(facing) < 0.02) continue;
                    const Rgb light =
                        world->transmittance({hit.position, way}, hit.tolerance, 10 * size + off);
                    if (facing > 0)
                        specks += light != Rgb(1);
                    else
                        leaks += light != Rgb(0);
                }
                CHECK(specks == 0);
                CHECK(leaks == 0);
            }
}

}  // namespace

TEST_CASE("hits do not depend on the tree, whatever the numbers", "[world]") {
    agree(KdTree(), 4000);
    agree(BoundingBoxes(), 4000);
}

TEST_CASE("solids neither shadow themselves nor leak, whatever the numbers", "[world]") {
    keep_tight(500);
}

TEST_CASE("what is too large for numbers does others no harm", "[world]") {
    const std::string small =
        "#for (I, 0, 39) sphere { <mod(I, 8), div(I, 8), 0>, 0.2 } #end\n"
        "light_source { -9*z, 1 }\n";
    const std::string huge_box =
        "box { -1, 1 translate 1e29*x scale 1e99 scale 1e99 scale 1e99 rotate <10, 20, 30> ";
    const std::string huge_mesh =
        "mesh { #for (I, 0, 19) triangle { <1e308, I, 1>, <-1.7e308, I, 2>, <3, 1.7e308, I> } "
        "#end ";
    for (const std::string& thing :
         {std::string("sphere { 0, 1e210 scale 1e100 "),
          std::string("sphere { <1e210, 0, 0>, 1 scale 1e100 "), huge_box, huge_mesh,
          "intersection { " + huge_mesh + "inside_vector y } sphere { 0, 1 } ",
          "union { " + huge_box + "} sphere { y, 1 scale 1e95 scale 1e95 scale 1e95 } "})
        for (const char* look : {"}", "pigment { rgbt 1 } finish { emission 1 } }"}) {
            INFO(thing << look);
            const SharedWorld world = world_of(small + thing + look);
            Hit hit;
            REQUIRE(world->first_hit({Vec3(3, 2, -1), Vec3(0, 0, 1)}, 0, RayKind::camera, hit));
            CHECK(hit.position.z == Approx(-0.2));
            world->transmittance({Vec3(3, 2, -1), Vec3(0, 0, 1)}, 0, 5);
        }
}

TEST_CASE("the same with millions of rays", "[.long]") {
    agree(KdTree(), 300'000);
    agree(BoundingBoxes(), 300'000);
    keep_tight(50'000);
}

}  // namespace candelabra
