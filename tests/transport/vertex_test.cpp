// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/vertex.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a vertex looks to the side that is seen", "[transport]") {
    const SharedWorld world = world_of("sphere { 0, 1 pigment { rgbt <1, 0.5, 0, 0.25> } }");
    for (const double from : {-3.0, 0.0}) {
        const Ray ray{Vec3(0, 0, from), Vec3(0, 0, 1)};
        Hit hit;
        REQUIRE(world->first_hit(ray, 0, RayKind::camera, hit));
        const Vertex vertex = vertex_at(*world, ray, hit);
        CHECK(vertex.shading.geometric_normal.z == Approx(-1));
        CHECK(vertex.position().z == Approx(from < 0 ? -1 : 1));
        double weights = 0;
        for (const auto& [weight, layers] : visible_textures(*world, vertex)) {
            weights += weight;
            const Shading s = with_layer(*world, vertex, layers.front());
            CHECK(s.colour.rgb == Rgb(1, 0.5, 0));
            CHECK(s.opacity == Approx(0.75));
            CHECK(receiver(s).horizon == Horizon::one_side);
        }
        CHECK(weights == Approx(1));
    }
}

TEST_CASE("normals decide which side of a smooth face is the outer one", "[transport]") {
    const std::string looks =
        "texture { pigment { rgb x } } interior_texture { pigment { rgb z } } ";
    for (const bool wound : {false, true})
        for (const bool up : {false, true})
            for (const std::string form : {"mesh", "mesh2", "clipped", "mirrored", "flat"}) {
                const std::string n = up ? "" : "-";
                const std::string corners[] = {"<-1, 0, -1>", wound ? "<1, 0, 1>" : "<-1, 0, 1>",
                                               wound ? "<-1, 0, 1>" : "<1, 0, 1>"};
                const std::string normals[] = {n + "<0.3, 1, 0>", n + "<0, 1, 0.3>",
                                               n + "<-0.3, 1, 0>"};
                std::string script = "#version 3.7; mesh { smooth_triangle { ";
                if (form == "mesh2" || form == "mirrored") {
                    script = "#version 3.7; mesh2 { vertex_vectors { 3, " + corners[0] + ", " +
                             corners[1] + ", " + corners[2] + " } normal_vectors { 3, " +
                             normals[0] + ", " + normals[1] + ", " + normals[2] +
                             " } face_indices { 1, <0, 1, 2> } " + looks +
                             (form == "mesh2" ? "}" : "scale <-1, 1, 1> }");
                } else if (form == "flat") {
                    script = "#version 3.7; mesh { triangle { " + corners[0] + ", " + corners[1] +
                             ", " + corners[2] + " } " + looks + "}";
                } else {
                    for (int i = 0; i < 3; ++i)
                        script += (i ? ", " : "") + corners[i] + ", " + normals[i];
                    script +=
                        " } " + looks + (form == "mesh" ? "}" : "clipped_by { box { -1, 1 } } }");
                }
                CAPTURE(script);
                const SharedWorld world = world_of(script);
                for (const double side : {1.0, -1.0}) {
                    const Ray ray{Vec3(-0.1, 3 * side, 0.2), Vec3(0, -side, 0)};
                    Hit hit;
                    REQUIRE(world->first_hit(ray, 0, RayKind::camera, hit));
                    const bool outer = form == "flat" ? wound == (side > 0) : up == (side > 0);
                    for (const auto& [weight, layers] :
                         visible_textures(*world, vertex_at(*world, ray, hit)))
                        CHECK(layers.front().colour.rgb == (outer ? Rgb(1, 0, 0) : Rgb(0, 0, 1)));
                }
            }
}

TEST_CASE("textures of a small share are left out", "[transport]") {
    const SharedWorld world = world_of(
        "blob { threshold 0.5 sphere { 0, 2, 2 pigment { rgb 1 } } "
        "sphere { <0, 1, 0>, 2, 0.1 pigment { rgb 0 } } }");
    const Ray ray{Vec3(0, 0, -3), Vec3(0, 0, 1)};
    Hit hit;
    REQUIRE(world->first_hit(ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(*world, ray, hit);
    CHECK(visible_textures(*world, vertex).size() == 2);
    CHECK(visible_textures(*world, vertex, 0.2).size() == 1);
}

}  // namespace candelabra
