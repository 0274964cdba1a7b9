// SPDX-License-Identifier: GPL-3.0-or-later
// Appearance that depends on the place on a surface.
#include "shape/uv.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the unlit colour that a ray along z sees at x, y.
Rgb seen(const World& world, double x, double y) {
    Hit hit;
    if (!world.first_hit({Vec3(x, y, -5), Vec3(0, 0, 1)}, 0, RayKind::camera, hit)) return Rgb(-1);
    const PatternScene scene = world.pattern_scene(hit.primitive, hit.part, hit.position);
    Rgb sum(0);
    world.for_textures(hit.primitive, hit.part, hit.position, Side::outer,
                       [&](double share, const Texture& texture, const Transform*) {
                           sum += share * evaluate(texture.pigment, hit.position, scene).rgb;
                       });
    return sum;
}

constexpr auto mesh = R"(#version 3.7;
    #declare T = array[3] { texture { pigment { rgb x } } texture { pigment { rgb y } }
                            texture { pigment { rgb z } } }
    #declare M = mesh {
        triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> texture_list { T[0], T[1], T[2] } }
        triangle { <1, 1, 0>, <1, 0, 0>, <0, 1, 0> texture { T[1] } }
        inside_vector x
    }
)";

bool close(const Rgb& a, const Rgb& b) { return max_abs_component(a - b) < 1e-9; }

}  // namespace

TEST_CASE("a triangle of its own has u and v of its place, as in POV-Ray", "[world]") {
    for (const char* kind : {"triangle { 0, x, y ", "smooth_triangle { 0, -z, x, -z, y, -z "}) {
        const SharedWorld world =
            world_of(std::string("#version 3.7; ") + kind +
                     "uv_mapping pigment { gradient x } translate <4, 2, 0> }");
        CHECK(close(seen(*world, 4.25, 2.125), Rgb(0.25)));
    }
}

TEST_CASE("the textures of a face's corners are mixed", "[world]") {
    const SharedWorld world = world_of(std::string(mesh) + "object { M }");
    CHECK(close(seen(*world, 0.2, 0.3), Rgb(0.5, 0.2, 0.3)));
    CHECK(close(seen(*world, 0.7, 0.6), Rgb(0, 1, 0)));
}

TEST_CASE("faces of a mesh in an intersection keep their textures", "[world]") {
    const SharedWorld world =
        world_of(std::string(mesh) + "object { M clipped_by { box { <0, 0, -1>, <0.8, 2, 1> } } }");
    CHECK(close(seen(*world, 0.2, 0.3), Rgb(0.5, 0.2, 0.3)));
    CHECK(close(seen(*world, 0.7, 0.6), Rgb(0, 1, 0)));
    CHECK(seen(*world, 0.9, 0.6) == Rgb(-1));
}

TEST_CASE("what is on u and v is turned with its object", "[world]") {
    const std::string sphere = "#version 3.7; sphere { 0, 1 uv_mapping pigment { gradient x } ";
    // Seen along z: u is 0.75 at -z.
    CHECK(seen(*world_of(sphere + "}"), 0, 0).r == Approx(0.75));
    CHECK(seen(*world_of(sphere + "rotate -90*y scale 2 }"), 0, 0).r == Approx(0.5));
    CHECK(seen(*world_of("#version 3.7; union { sphere { 0, 1 } rotate -90*y "
                         "pigment { uv_mapping gradient x } }"),
               0, 0)
              .r == Approx(0.5));
}

TEST_CASE("u and v of meshes and of leaves", "[world]") {
    const std::string triangle =
        "#version 3.7; mesh { triangle { 0, x, y uv_vectors <0, 0>, <0.5, 0>, <0, 1> } "
        "inside_vector z uv_mapping pigment { gradient x } ";
    for (const auto* end : {"}", "clipped_by { box { -1, 2 } } }"})
        CHECK(seen(*world_of(triangle + end), 0.4, 0.1).r == Approx(0.2));
    const std::string plane =
        "#version 3.7; plane { z, 0 pigment { uv_mapping gradient y } translate y }";
    CHECK(seen(*world_of(plane), 0.4, 0.1).r == Approx(0.1));
}

TEST_CASE("textures of a blob's components are mixed by the strength of their fields", "[world]") {
    const std::string blob =
        "#version 3.7; blob { threshold 0.2 "
        "sphere { -0.5*x, 1, 1 pigment { rgb x } } "
        "sphere { 0.5*x, 1, -0.5 texture { pigment { rgb y } } } "
        "cylinder { <0, -1, 0>, <0, 1, 0>, 0.6, 0.3 } ";
    const auto field = [](double distance2, double radius) {
        const double nearness = std::max(0.0, 1 - distance2 / (radius * radius));
        return nearness * nearness;
    };
    for (const auto* end :
         {"pigment { rgb z } }", "pigment { rgb z } clipped_by { box { -2, 2 } } }",
          "pigment { rgb z } rotate 90*z rotate -90*z }"})
        for (const double x : {-0.9, -0.3, -0.1}) {
            const SharedWorld world = world_of(blob + end);
            Hit hit;
            REQUIRE(world->first_hit({Vec3(x, 0, -5), Vec3(0, 0, 1)}, 0, RayKind::camera, hit));
            const double z2 = hit.position.z * hit.position.z;
            const Rgb strengths(field((x + 0.5) * (x + 0.5) + z2, 1),
                                field((x - 0.5) * (x - 0.5) + z2, 1) / 2,
                                field(x * x + z2, 0.6) * 0.3);
            CAPTURE(end, x);
            CHECK(close(seen(*world, x, 0), strengths / (strengths.r + strengths.g + strengths.b)));
        }
}

TEST_CASE("a component that glows makes a luminaire of its blob", "[world]") {
    const SharedWorld world = world_of(
        "#version 3.7; blob { threshold 0.2 sphere { 0, 1, 1 pigment { "
        "rgb 1 } finish { emission 2 } } sphere { x, 1, 1 } }");
    REQUIRE(world->lights.luminaires.size() == 1);
    CHECK(world->lights.luminaires.own()[0].radiance == Rgb(2));
    CHECK(world->lights.luminaires.own()[0].varying);
}

}  // namespace candelabra
