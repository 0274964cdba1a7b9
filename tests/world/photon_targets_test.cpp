// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/photon_targets.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

SharedWorld targets(const std::string& objects,
                    const std::string& settings = "photons { count 100 }") {
    return world_of("#version 3.7; global_settings { " + settings + " } " + objects);
}

const std::string lamp = "light_source { <0, 9, 0>, rgb 1 photons { refraction on } } ";
const std::string glass = "pigment { rgbt 1 } interior { ior 1.5 } photons { target } ";

}  // namespace

TEST_CASE("targets have balls around them", "[world]") {
    const SharedWorld world =
        targets(lamp + "sphere { <1, 2, 3>, 0.5 " + glass + "} box { -1, 1 " + glass + "}");
    REQUIRE(world->photon_targets.size() == 2);
    CHECK(world->photon_targets[0].centre == Vec3(1, 2, 3));
    CHECK(world->photon_targets[0].radius == 0.5);
    CHECK(world->photon_targets[1].radius == Approx(std::sqrt(3.0)));
    CHECK(world->photon_targets[1].shot_at);
}

TEST_CASE("a union is one target, and parts may differ from it", "[world]") {
    const SharedWorld world =
        targets(lamp +
                "union { sphere { -3*x, 1 } sphere { 3*x, 1 } sphere { 9*y, 1 photons { "
                "collect off } } " +
                glass + "}");
    REQUIRE(world->photon_targets.size() == 1);
    CHECK(world->photon_targets[0].centre == Vec3(0));
    int of_target = 0;
    for (PrimitiveIndex i = 0; i < 3; ++i) of_target += world->material(i).photons.target != 0;
    CHECK(of_target == 2);
}

TEST_CASE("without a light that shoots there are no targets", "[world]") {
    const std::string ball = "sphere { 0, 1 " + glass + "} ";
    CHECK_FALSE(targets(lamp + ball)->photon_targets.empty());
    for (const char* light : {"light_source { 9*y, rgb 1 }",
                              "light_source { 9*y, rgb 1 shadowless photons { refraction on } }",
                              "light_source { 9*y, rgb 1 photons { refraction off } }",
                              "sphere { 9*y, 1 pigment { rgb 1 } finish { emission 1 } }"})
        CHECK(targets(light + ball)->photon_targets.empty());
    CHECK_FALSE(targets("sphere { 9*y, 1 pigment { rgb 1 } finish { emission 1 } } sphere { 0, 1 " +
                        glass + "photons { refraction on } }")
                    ->photon_targets.empty());
    for (const char* settings : {"", "photons { }"})
        CHECK(targets(lamp + ball, settings)->photon_targets.empty());
    CHECK(targets(lamp + "sphere { 0, 1 no_shadow " + glass + "}")->photon_targets.empty());
    CHECK(targets(lamp + "sphere { 0, 1 no_image " + glass + "}")->photon_targets.empty());
}

TEST_CASE("an object whose target is off is none", "[world]") {
    for (const char* off : {"target off", "target 0", "target no refraction on"}) {
        CAPTURE(off);
        Diagnostics diagnostics;
        const std::string photons = std::string("photons { ") + off + " } ";
        const SharedWorld world =
            compile(scene_of("#version 3.7; global_settings { photons { count 100 } } " + lamp +
                             "sphere { 0, 1 " + glass + photons + "} plane { y, -2 " + photons +
                             "} sphere { 5, 1 " + glass + "}"),
                    CompileOptions(), diagnostics);
        CHECK(diagnostics.all().empty());
        REQUIRE(world->photon_targets.size() == 1);
        CHECK(world->photon_targets[0].centre == Vec3(5));
    }
}

TEST_CASE("lights of a light group shoot, too", "[world]") {
    CHECK_FALSE(targets("light_group { " + lamp + "sphere { 0, 1 " + glass + "} }")
                    ->photon_targets.empty());
}

TEST_CASE("lamps shoot at targets in a bounded number of pairs", "[world]") {
    const auto said = [](int lamps, int glasses, const std::string& ways) {
        const auto times = [](int count, const std::string& what) {
            return "#for (I, 1, " + std::to_string(count) + ") " + what + " #end ";
        };
        Diagnostics diagnostics;
        const std::string script =
            "#version 3.7; global_settings { photons { count 100 } } " +
            times(lamps, "light_source { I*y, rgb 1 photons { " + ways + " } }") +
            times(glasses, "box { I, I + 0.1 " + glass + "}");
        compile(scene_of(script), CompileOptions(), diagnostics);
        return diagnostics.failed() ? diagnostics.all().back().message : "";
    };
    CHECK(said(4000, 2000, "refraction on") == "");
    CHECK(said(4001, 2000, "refraction on") ==
          "photons of light sources are shot at targets in more pairs than the limit of 8000000: "
          "there are 8002000");
    CHECK(said(4001, 2000, "refraction off") == "");
}

TEST_CASE("photons are not shot at what has no end", "[world]") {
    Diagnostics said;
    const SharedWorld world =
        compile(scene_of("#version 3.7; global_settings { photons { count 9 } } " + lamp +
                         "plane { y, 0 " + glass + "}"),
                {}, said);
    CHECK(world->photon_targets.empty());
    CHECK(said.count() == 1);
}

TEST_CASE("light that photons bring does not come straight", "[world]") {
    const SharedWorld world = targets(lamp + "sphere { 0, 1 " + glass + "} sphere { 5*y, 1 " +
                                      glass + "photons { refraction off } }");
    const PhotonWays ways = ways_of_source(*world, 0);
    const Ray up{Vec3(0, -3, 0), Vec3(0, 1, 0)};
    CHECK(target_between(*world, ways, up, 1e-9, 12));
    CHECK_FALSE(target_between(*world, ways, up, 1e-9, 2));
    CHECK_FALSE(target_between(*world, ways_of_luminaires, up, 1e-9, 12));
    CHECK_FALSE(target_between(*world, ways, {Vec3(0, 3, 0), Vec3(0, 1, 0)}, 1e-9, 6));
}

}  // namespace candelabra
