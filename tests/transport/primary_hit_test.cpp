// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/primary_hit.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

SharedWorld remembering(const std::string& script) {
    CompileOptions options;
    options.remembers_objects = true;
    Diagnostics diagnostics;
    return compile(scene_of(script), options, diagnostics);
}

const std::string scene = R"(#version 3.7;
camera { location -5*z look_at 0 }
plane { y, -1 pigment { rgb 0.3 } }
#for (I, 0, 2)
    sphere { <2*I - 2, 0, 0>, 0.5 pigment { rgb <1, 0.5, 0> } finish { diffuse 0.2 } }
#end
union { box { <-1, 2, 0>, <-0.5, 3, 1> } box { <0.5, 2, 0>, <1, 3, 1> } pigment { rgbt <1, 1, 1, 0.4> } }
difference { box { <-1, -5, 0>, <1, -4, 1> } sphere { 0, 1 } })";

}  // namespace

TEST_CASE("what a ray meets first has a colour, a direction, a distance and an object",
          "[render]") {
    const SharedWorld world = remembering(scene);
    const auto look = [&](const Vec3& from, const Vec3& to) {
        return primary_hit(*world, {from, unit(to - from)});
    };
    const PrimaryHit ball = look({0, 0, -5}, Vec3(0));
    CHECK(ball.met);
    CHECK(ball.distance == Approx(4.5));
    CHECK(ball.albedo.g == Approx(0.5));  // the pigment's colour, whatever the finish
    CHECK(ball.normal.z == Approx(-1));
    REQUIRE(texture_at(*world, ball));
    CHECK(texture_at(*world, ball)->finish.diffuse == Approx(0.2));
    const PrimaryHit floor = look({0, 0, -5}, {0, -1, -3});
    CHECK(floor.albedo == Rgb(0.3));
    CHECK(floor.normal.y == Approx(1));
    const PrimaryHit clear = look({-0.7, 2.5, -5}, {-0.7, 2.5, 0});
    CHECK(clear.albedo.r == Approx(0.6));  // weighted by its opacity
    const PrimaryHit nothing = look({0, 0, -5}, {0, 9, -5});
    CHECK_FALSE(nothing.met);
    CHECK(nothing.object == 0);
    CHECK(texture_at(*world, nothing) == nullptr);
}

TEST_CASE("objects have numbers in the order of the scene", "[render]") {
    const SharedWorld world = remembering(scene);
    const auto number = [&](const Vec3& at) {
        return primary_hit(*world, {at - Vec3(0, 0, 5), Vec3(0, 0, 1)}).object;
    };
    CHECK(number({0, -0.999, 0}) == 0);
    CHECK(primary_hit(*world, {Vec3(5, 0, 0), Vec3(0, -1, 0)}).object == 1);
    // Each sphere of a loop and each part of a union counts as one; a difference counts as one.
    CHECK(number({-2, 0, 0}) == 2);
    CHECK(number({2, 0, 0}) == 4);
    CHECK(number({-0.7, 2.5, 0}) == 5);
    CHECK(number({0.7, 2.5, 0}) == 6);
    CHECK(number({0, -4.5, 0}) == 7);
    CHECK(world->provenance.object_spans.size() == 7);
    CHECK(world->provenance.object_count == 7);
    CHECK(world_of(scene)->provenance.object_of.empty());
}

}  // namespace candelabra
