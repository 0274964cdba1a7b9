// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/models.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<std::size_t> rows(const std::vector<ObjectHandle>& list) {
    std::vector<std::size_t> lengths;
    for (const ObjectHandle& object : list) {
        const auto* row = std::get_if<SphereRow>(&object->form);
        lengths.push_back(row ? row->spheres.size() : 0);
    }
    return lengths;
}

}  // namespace

TEST_CASE("spheres that are alike become a row", "[objects]") {
    struct Case {
        const char* script;
        std::vector<std::size_t> lengths;  ///< 0: no row
    };
    // The first two passes analyse the block.
    const auto [script, lengths] = GENERATE(Catch::Generators::values<Case>({
        {"#for (I, 1, 9) sphere { I, 1 } #end", {0, 0, 7}},
        {"#for (I, 1, 9) sphere { I, 1 pigment { rgb 1 } } #end", {0, 0, 7}},
        {"#for (I, 1, 4) sphere { I, 1 } box { 0, I } #end", {0, 0, 0, 0, 1, 0, 1, 0}},
        {"#for (I, 1, 4) sphere { I, 1 } sphere { I, 2 } #end", {0, 0, 0, 0, 4}},
        {"#for (I, 1, 4) sphere { I, 1 } sphere { I, 2 no_shadow } #end", {0, 0, 0, 0, 1, 1, 1, 1}},
        {"#for (I, 1, 4) sphere { I, 1 inverse } #end", {0, 0, 0, 0}},
        {"#for (I, 1, 2500) sphere { I, 1 } #end", {0, 0, 2048, 450}},
    }));
    INFO(script);
    CHECK(rows(scene_of(script).objects) == lengths);
    const Scene within = scene_of("union { " + std::string(script) + " }");
    CHECK(rows(std::get<Union>(within.objects.at(0)->form).children) == lengths);
}

TEST_CASE("declared spheres that a loop only moves become a row", "[objects]") {
    struct Case {
        const char* script;
        std::vector<std::size_t> lengths;  ///< 0: no row
    };
    const auto [script, lengths] = GENERATE(Catch::Generators::values<Case>({
        {"#for (I, 1, 9) object { S translate I } #end", {9}},
        {"#for (I, 1, 9) object { S translate I no_shadow } #end", {9}},
        {"#for (I, 1, 2500) object { S translate I } #end", {2048, 452}},
        {"#for (I, 1, 3) object { S translate I scale 2 } #end", {0, 0, 0}},
        {"#for (I, 1, 3) object { S translate I pigment { rgb 1/I } } #end", {0, 0, 0}},
        {"#for (I, 1, 3) object { S translate I interior { ior 1.5 } } #end", {0, 0, 0}},
        {"#for (I, 1, 3) object { S translate I } box { 0, I } #end", {0, 0, 0, 0, 0, 0}},
        {"object { S translate x } object { S translate y }", {0, 0}},
        {"#for (I, 1, 3) object { P translate I } #end", {0, 0, 0}},
    }));
    INFO(script);
    const Scene scene = scene_of(
        "#declare S = sphere { <0, 1, 0>, 0.5 pigment { rgb 1 } } "
        "#declare P = sphere { 0, 1 pigment { checker } } " +
        std::string(script));
    CHECK(rows(scene.objects) == lengths);
    if (lengths.front() == 0) return;
    const auto& row = std::get<SphereRow>(scene.objects.front()->form);
    CHECK_FALSE(scene.objects.front()->transform);
    CHECK(row.spheres[2].centre == Vec3(3, 4, 3));
    CHECK(row.spheres[2].radius == 0.5);
    CHECK(scene.objects.front()->parts == lengths.front());
}

TEST_CASE("a row that is declared stays as it is", "[objects]") {
    const Scene scene = scene_of(
        "#declare U = union { #for (I, 1, 9) sphere { I, 1 } #end } object { U } object { U scale "
        "2 } union { object { U } sphere { 0, 1 } }");
    CHECK(world_of("#declare U = union { #for (I, 1, 9) sphere { I, 1 } #end } "
                   "object { U } object { U scale <1, 2, 1> } difference { object { U } box { 0, 1 "
                   "} }")
              ->provenance.object_count == 19);
    REQUIRE(scene.objects.size() == 3);
    for (const ObjectHandle& object : scene.objects)
        CHECK(std::holds_alternative<Union>(object->form));
}

}  // namespace candelabra
