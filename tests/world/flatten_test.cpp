// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/flatten.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("children inherit what they do not say", "[world]") {
    const SharedWorld world = world_of(R"(
        union {
            sphere { 0, 1 }
            sphere { 5, 1 pigment { rgb 0.5 } }
            pigment { rgb 0.25 }
            no_shadow
        }
    )");
    REQUIRE(world->geometry.spheres.size() == 2);
    CHECK(world->material(0).texture->pigment.colour.rgb.r == 0.25);
    CHECK(world->material(1).texture->pigment.colour.rgb.r == 0.5);
    CHECK(world->material(1).no_shadow);
}

TEST_CASE("textures move with the unions around them", "[world]") {
    const SharedWorld world = world_of(R"(
        union {
            sphere { 0, 1 pigment { gradient x } }
            translate 10.25*x
        }
    )");
    CHECK(evaluate(world->material(0).texture->pigment, Vec3(10.5, 0, 0)).rgb.r == Approx(0.25));
}

TEST_CASE("many copies of an object share their looks", "[world]") {
    const SharedWorld world = world_of(R"(
        #declare Lamp = union { sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } } cylinder { 0, y, 0.1 pigment { rgb 0 } } }
        #for (I, 1, 100) object { Lamp translate 3*I*x } #end
    )");
    CHECK(world->provenance.object_count == 200);
    CHECK(world->appearance.materials.size() == 2);
    CHECK(world->lights.luminaires.size() == 100);
}

TEST_CASE("a luminaire that cannot light says so", "[world]") {
    Diagnostics diagnostics;
    const Scene scene = scene_of("plane { y, 0 pigment { rgb 1 } finish { emission 1 } }");
    compile(scene, {}, diagnostics);
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].severity == Severity::warning);
}

TEST_CASE("bounds that POV-Ray removes cut nothing away", "[world]") {
    const std::string box = "bounded_by { box { <0, -3, -3>, 3 } } }",
                      tight = "bounded_by { sphere { 2*x, 0.1 } } }";
    struct Case {
        std::string script;
        bool seen;
    };
    for (const Case& c : std::vector<Case>{
             {"sphere { 0, 1 " + tight, true},
             {"sphere { 0, 1 rotate y " + tight, true},
             {"sphere { 0, 1 clipped_by { plane { x, 0.1 } } " + tight, true},
             {"sphere { 0, 1 clipped_by { plane { -x, -0.1 } } " + tight, false},
             {"quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.26, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, "
              "2, 0, "
              "1.74, 0, 0, 0, 0, 1, 0, -2.26, 0, .7569> translate x " +
                  tight,
              false},
             {"union { sphere { 0, 1 } sphere { x, 1 } " + box, true},
             {"union { sphere { 0, 1 } sphere { x, 1 } " + tight, false},
             {"union { sphere { 0, 1 } plane { y, -5 } " + box, false},
             {"difference { sphere { 0, 1 } sphere { -9*x, 1 } " + box, false},
             {"union { sphere { 0, 1 " + tight + " sphere { 9*x, 1 } }", true},
             {"intersection { sphere { 0, 1 " + tight + " sphere { 0, 2 } }", false}}) {
        CAPTURE(c.script);
        const SharedWorld world = world_of("#version 3.7; " + c.script);
        Hit hit;
        CHECK(world->first_hit({Vec3(-0.1, 0.1, -9), Vec3(0, 0, 1)}, 0, RayKind::camera, hit) ==
              c.seen);
    }
}

TEST_CASE("parts of a union share the interior that it gives them", "[world]") {
    const auto solids = [](const std::string& script) {
        const SharedWorld world = world_of("#version 3.7; " + script);
        std::vector<std::uint32_t> result;
        for (PrimitiveIndex i = 0; i < world->appearance.material_of.size(); ++i)
            result.push_back(world->solid(i));
        std::ranges::sort(result);
        return std::unique(result.begin(), result.end()) - result.begin();
    };
    const std::string parts = "sphere { 0, 1 } box { 0, 1 } ", glass = "interior { ior 1.5 } } ";
    CHECK(solids("union { " + parts + glass) == 1);
    CHECK(solids("#declare U = union { " + parts + glass + "object { U } object { U }") == 2);
    CHECK(solids("union { " + parts + "sphere { 2, 1 " + glass + glass) == 2);
    CHECK(solids("union { " + parts + "}") == 2);
    CHECK(solids("union { union { " + parts + "} difference { " + parts + "} " + glass) == 1);
    // Parts of a composite with their own interiors are separate solids.
    CHECK(solids("intersection { " + parts + glass) == 1);
    CHECK(solids("intersection { sphere { 0, 1 " + glass + "box { 0, 1 } }") == 2);
    CHECK(solids("difference { union { " + parts + glass + "box { 0, 1 " + glass + glass) == 2);
    CHECK(solids("#declare B = box { 0, 1 " + glass +
                 "merge { object { B } object { B translate x } }") == 2);
    CHECK(solids("#declare D = difference { " + parts + glass + "object { D } object { D }") == 2);
}

}  // namespace candelabra
