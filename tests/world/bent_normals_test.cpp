// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/bent_normals.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Bent normals of the luminaires of a scene, with the camera at `eye`.
std::vector<Vec3> bent_normals(const std::string& text, const std::string& eye = "<0, 20, -50>") {
    const Shot shot =
        shot_of("#version 3.7; camera { location " + eye + " look_at 0 }\n" +
                "#declare G = texture { pigment { rgb 1 } finish { emission 1 } }\n" + text);
    return shot.bent_normals;
}

const std::string far = "sphere { <500, 0, 0>, 1 texture { G } }\n";
const std::string window = "box { <-0.2, 1, -1.02>, <0.2, 1.5, -0.98> texture { G } }\n";

}  // namespace

TEST_CASE("luminaires that nothing is next to have no bent normal", "[world]") {
    for (const Vec3& bent : bent_normals(far + "sphere { 0, 1 texture { G } }"
                                               "box { <-1, 4, -0.1>, <1, 6, 0.1> texture { G } }"))
        CHECK(bent == Vec3(0));
}

TEST_CASE("a window's bent normal points away from its house, whatever that is made of",
          "[world]") {
    for (const char* house : {"box { <-1, 0, -1>, <1, 3, 1> }", "cylinder { 0, 3*y, 1 }",
                              "difference { box { <-1, 0, -1>, <1, 3, 1> } sphere { 3*y, 0.5 } }",
                              "object { box { -1, 1 } translate y scale <1, 1.5, 1> }",
                              "box { <-1, 0, -0.95>, <1, 3, 1> }"}) {
        INFO(house);
        const std::vector<Vec3> found = bent_normals(far + window + house);
        REQUIRE(found.size() == 2);
        CHECK(found[0] == Vec3(0));
        CHECK(found[1].z < -0.3);
        CHECK(length(found[1]) < 0.5);
    }
}

TEST_CASE("the bent normal of a ball half in a box points out of it, one that lies on it has none",
          "[world]") {
    const std::string box = " box { <-9, -9, -9>, <9, 0, 9> }";
    const std::vector<Vec3> half_in = bent_normals(far + "sphere { 0, 1 texture { G } }" + box);
    CHECK(half_in[1].y > 0.2);
    CHECK(length(half_in[1]) < 0.5);
    CHECK(bent_normals(far + "sphere { y, 1 texture { G } }" + box)[1] == Vec3(0));
    CHECK(bent_normals(far + "sphere { y, 1 texture { G } } plane { y, 0 }")[1] == Vec3(0));
}

TEST_CASE("a solid that the eye is in hides nothing, nor does one that light passes", "[world]") {
    const std::string balls = far + "sphere { 0, 1 texture { G } }";
    for (const Vec3& bent : bent_normals(balls + "box { <-100, -30, -80>, <10, 40, 80> }"))
        CHECK(bent == Vec3(0));
    for (const Vec3& bent : bent_normals(balls + "sphere { 0, 1.5 pigment { rgbt 1 } }"))
        CHECK(bent == Vec3(0));
    for (const Vec3& bent : bent_normals(balls + "sphere { 0, 1.5 no_shadow }"))
        CHECK(bent == Vec3(0));
}

TEST_CASE("a luminaire whose light gets nowhere has no bent normal", "[world]") {
    CHECK(bent_normals(far + "sphere { 0, 1 texture { G } } box { -2, 2 }")[1] == Vec3(0));
}

TEST_CASE("bent normals are the same for any number of threads", "[world]") {
    std::string text = far + "box { <-90, -9, -90>, <90, 0.2, 90> }";
    for (int i = 0; i < 600; ++i)
        text += "sphere { <" + std::to_string(i % 25) + ", 0.2, " + std::to_string(i / 25) +
                ">, 0.3 texture { G } }\n";
    Diagnostics diagnostics;
    const Scene scene = scene_of(
        "#version 3.7;\n#declare G = texture { pigment { rgb 1 } finish { emission 1 } }\n" + text);
    const SharedWorld world = compile(scene, {}, diagnostics);
    const auto found = [&](int threads) { return find_bent_normals(*world, Vec3(0), 1, threads); };
    CHECK(found(1).size() == 601);
    CHECK(found(1) == found(3));
}

TEST_CASE("the more pixels a picture has, the more luminaires have bent normals", "[world]") {
    Diagnostics diagnostics;
    const Scene scene = scene_of(R"(
        #version 3.7;
        box { <-1, -1, -1>, <400, 0, 400> }
        #for (I, 0, 139999)
            sphere { <mod(I, 374), 0, int(I/374)>, 0.1 pigment { rgb 1 } finish { emission 1 } }
        #end)");
    const SharedWorld world = compile(scene, {}, diagnostics);
    CHECK(find_bent_normals(*world, Vec3(0, 9, 0), 1000, 1).empty());
    const std::vector<Vec3> found = find_bent_normals(*world, Vec3(0, 9, 0), 140'000, 2);
    REQUIRE(found.size() == 140'000);
    double up = 0;
    for (const Vec3& bent : found) up += bent.y / 140'000;
    CHECK(up > 0.15);
}

}  // namespace candelabra
