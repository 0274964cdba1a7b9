// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/volumes.h"

#include "luminaire/volume.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string solid(const std::string& shape, const std::string& words,
                  const std::string& emission = "1") {
    return shape + " pigment { rgbt 1 } " + words + " interior { media { emission " + emission +
           " } luminaire } } ";
}

double intensity_of_all(const World& world) {
    double sum = 0;
    for (const MediaBox& each : world.lights.media) sum += bounds(each).intensity;
    return sum;
}

}  // namespace

TEST_CASE("a solid of glowing media is cut into boxes", "[world]") {
    const SharedWorld world =
        world_of("#version 3.7; " + solid("sphere { <1, 2, 3>, 0.5", "hollow", "3"));
    REQUIRE(world->lights.volumes.size() == 1);
    CHECK(world->lights.media.size() > 30);
    CHECK(intensity_of_all(*world) == Approx(3 * 4.0 / 3 * std::acos(-1) / 8).epsilon(0.05));
    Box all;
    CHECK(world->lights.luminaires.empty());
    CHECK(world->lights.glowing() == world->lights.media.size());
    for (const MediaBox& each : world->lights.media) {
        CHECK(bounds(each).intensity > 0);
        all = join(all, bounds(each).box);
    }
    CHECK(length(all.low - Vec3(0.5, 1.5, 2.5)) < 1e-9);
    CHECK(length(all.high - Vec3(1.5, 2.5, 3.5)) < 1e-9);
    CHECK(world->lights.luminaire_of.empty());
}

TEST_CASE("a long solid is cut along its length", "[world]") {
    const SharedWorld world =
        world_of("#version 3.7; " + solid("cylinder { 0, 20*x, 0.1", "hollow"));
    CHECK(world->lights.media.size() > 40);
    for (const MediaBox& each : world->lights.media) CHECK(bounds(each).box.size().x < 0.5);
}

TEST_CASE("media glow within hollow solids only", "[world]") {
    const SharedWorld world = world_of(
        "#version 3.7; " + solid("sphere { 0, 1", "hollow") +
        solid("box { <4, -1, -1>, <6, 1, 1>", "hollow") +
        "sphere { <5, 0, 0>, 0.5 pigment { rgbt 1 } interior { ior 1.2 } } "
        "difference { sphere { <10, 0, 0>, 1 } sphere { <10, 0, 0>, 0.5 } pigment { rgbt 1 } "
        "hollow interior { media { emission 2 density { spherical translate 10*x } } luminaire } "
        "} ");
    REQUIRE(world->lights.volumes.size() == 3);
    const auto at = [&](std::size_t i, const Vec3& point) {
        return volume_emission(*world, world->lights.volumes[i].primitive, point).r;
    };
    CHECK(at(0, Vec3(0.5)) == 1);
    CHECK(at(0, Vec3(0.9)) == 0);
    CHECK(at(0, Vec3(5, 0.8, 0)) == 0);
    CHECK(at(1, Vec3(5, 0.8, 0)) == 1);
    CHECK(at(1, Vec3(5, 0.2, 0)) == 0);  // in the solid that is not hollow
    CHECK(at(2, Vec3(10, 0, 0.75)) == Approx(0.5));
    CHECK(at(2, Vec3(10, 0, 0.25)) == 0);
    const std::vector<PrimitiveIndex> around = {world->lights.volumes[1].primitive};
    CHECK(volume_among(*world, around) == &world->lights.volumes[1]);
    CHECK(volume_among(*world, {}) == nullptr);
}

TEST_CASE("parts that share their media glow once", "[world]") {
    // A ray enters and leaves them in turn, so nothing glows where two of them overlap.
    const SharedWorld world = world_of(
        "#version 3.7; union { sphere { 0, 1 } sphere { x, 1 } pigment { rgbt 1 } hollow "
        "interior { media { emission 1 } luminaire } } merge { sphere { 9*x, 1 } sphere { 10*x, 1 "
        "} pigment { rgbt 1 } hollow interior { media { emission 1 } luminaire } }");
    REQUIRE(world->lights.volumes.size() == 3);
    const PrimitiveIndex left = world->lights.volumes[0].primitive,
                         right = world->lights.volumes[1].primitive,
                         merged = world->lights.volumes[2].primitive;
    CHECK(volume_emission(*world, left, Vec3(-0.5, 0, 0)).r == 1);
    CHECK(volume_emission(*world, right, Vec3(-0.5, 0, 0)).r == 0);
    CHECK(volume_emission(*world, left, Vec3(0.5, 0, 0)).r == 0);
    CHECK(volume_emission(*world, merged, Vec3(9.5, 0, 0)).r == 1);
}

TEST_CASE("media without bounds are left to chance", "[world]") {
    const std::string shapes[] = {
        "sphere { 0, 1 inverse",
        "box { -1, 1 inverse",
        "plane { y, -2",
        "difference { plane { y, 9 } sphere { 0, 1 }",
        "intersection { sphere { 0, 1 inverse } box { -1, 1 inverse }",
        "union { sphere { 0, 1 inverse } sphere { 9*x, 1 }",
    };
    for (const std::string& shape : shapes) {
        INFO(shape);
        Diagnostics said;
        const SharedWorld world =
            compile(scene_of("#version 3.7; " + solid(shape, "hollow")), {}, said);
        CHECK(said.all().size() == 1);
        CHECK(world->lights.volumes.empty() == (shape.find("union") == shape.npos));
        for (PrimitiveIndex i = 0; i < world->appearance.material_of.size(); ++i) {
            const Box inside = world->geometry.inside_bounds(world->geometry.item_of(i));
            CHECK(lights_from_inside(world->material(i)) == finite(inside));
        }
    }
}

TEST_CASE("what says no is no luminaire", "[world]") {
    for (const char* const words : {"hollow no_luminaire", ""})
        CHECK(world_of("#version 3.7; " + solid("sphere { 0, 1", words))->lights.volumes.empty());
    CHECK(world_of("#version 3.7; global_settings { luminaires none } " +
                   solid("sphere { 0, 1", "hollow"))
              ->lights.volumes.empty());
    Diagnostics diagnostics;
    const SharedWorld endless =
        compile(scene_of("#version 3.7; " + solid("plane { y, 0", "hollow")), {}, diagnostics);
    CHECK(endless->lights.volumes.empty());
    CHECK(diagnostics.all().size() == 1);
}

TEST_CASE("a survey of a scene knows its volumes", "[world]") {
    Diagnostics diagnostics;
    const SharedWorld world =
        survey(scene_of("#version 3.7; light_source { 9, 1 } box { 0, 1 pigment { rgb 1 } } " +
                        solid("sphere { 0, 1", "hollow")),
               diagnostics);
    CHECK(world->lights.volumes.size() == 1);
    CHECK(world->lights.media.size() == 1);
}

}  // namespace candelabra
