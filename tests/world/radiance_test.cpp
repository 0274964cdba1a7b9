// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/radiance.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A surface that the luminaires light.
const std::string surface_below = "#version 3.7; disc { -50*y, y, 1 pigment { rgb 1 } } ";

/// Radiance of a world's first luminaire where a ray meets it, as seen at that distance.
Rgb seen_along(const World& world, const Vec3& from, const Vec3& towards, LightIndex light = 0) {
    REQUIRE(world.lights.luminaires.size() > light);
    const Luminaire& luminaire = world.lights.luminaires.own()[light];
    const Ray ray{from, unit(towards - from)};
    Rgb seen(0);
    world.along(ray, 0, RayKind::light, [&](const Hit& hit, double distance) {
        if (hit.primitive != luminaire.primitive) return true;
        seen = radiance_seen(world, luminaire, {ray, 0, distance});
        return false;
    });
    return seen;
}

}  // namespace

TEST_CASE("a glow may depend on how the surface faces, and on the ray", "[world]") {
    const auto seen = [](const std::string& pattern, const std::string& more, const Vec3& from) {
        const SharedWorld world = world_of(surface_below + "box { -1, 1 pigment { " + pattern +
                                           " color_map { [0 rgb x] [1 rgb z] } } " + more +
                                           "finish { emission 3 diffuse 0 } }");
        return seen_along(*world, from, Vec3(0));
    };
    const auto is = [](const Rgb& light, const Rgb& wanted) {
        const Rgb apart = light - wanted;
        return max_component(apart) < 1e-6 && max_component(-apart) < 1e-6;
    };
    CHECK(is(seen("slope y", "", Vec3(0, 5, 0)), Rgb(0, 0, 3)));
    CHECK(is(seen("slope y", "", Vec3(0, -5, 0)), Rgb(3, 0, 0)));
    CHECK(is(seen("slope y", "", Vec3(5, 0, 0)), Rgb(1.5, 0, 1.5)));
    CHECK(is(seen("aoi", "", Vec3(0, 5, 0)), Rgb(0, 0, 3)));
    // At 45 degrees the angle to the ray is three quarters of a half turn.
    CHECK(is(seen("aoi", "", Vec3(0, 5, 5)), Rgb(0.75, 0, 2.25)));
    // A layer whose opacity depends on it covers the glow below.
    const std::string layered =
        "texture { pigment { rgb 1 } finish { emission 3 diffuse 0 } } "
        "texture { pigment { slope y color_map { [0 rgb 0] [1 rgb 0 transmit 1] } } } ";
    const SharedWorld world = world_of(surface_below + "box { -1, 1 " + layered + "}");
    CHECK(is(seen_along(*world, Vec3(0, 5, 0), Vec3(0)), Rgb(3)));
    CHECK(is(seen_along(*world, Vec3(0, -5, 0), Vec3(0)), Rgb(0)));
    CHECK(is(seen_along(*world, Vec3(5, 0, 0), Vec3(0)), Rgb(1.5)));
}

TEST_CASE("a luminaire has the radiance of the side that is seen", "[world]") {
    const std::string red = "{ pigment { rgb x } finish { emission 3 diffuse 0 } }",
                      dark = "{ pigment { rgb 0 } finish { diffuse 0 } }";
    for (const char* const shape :
         {"disc { 0, y, 1", "sphere { 0, 1", "box { -1, 1", "cylinder { -y, y, 1 open",
          "superellipsoid { <1, 1>", "difference { box { -1, 1 } box { <-0.5, -0.5, -0.5>, 2 }",
          "triangle { <-9, 0, -9>, <9, 0, -9>, <0, 0, 9>", "sphere { 0, 1 scale <1, 2, 1>"})
        for (const bool inner : {false, true}) {
            CAPTURE(shape, inner);
            const SharedWorld world =
                world_of(surface_below + shape + " texture " + (inner ? dark : red) +
                         " interior_texture " + (inner ? red : dark) + " }");
            REQUIRE_FALSE(world->lights.luminaires.empty());
            CHECK(world->lights.luminaires.own()[0].one_sided);
            CHECK(world->lights.luminaires.own()[0].radiance == Rgb(3, 0, 0));
            Hit hit;
            const Ray ray{Vec3(0.1, 5, 0.2), unit(Vec3(0.8, -5, 0))};
            REQUIRE(world->first_hit(ray, 0, RayKind::camera, hit));
            const bool sees_inner = hit.side_towards(ray.direction) == Side::inner;
            const Rgb seen = seen_along(*world, ray.origin, ray.origin + ray.direction,
                                        world->lights.luminaire_of[hit.primitive]);
            CHECK(seen == (sees_inner == inner ? Rgb(3, 0, 0) : Rgb(0)));
        }
}

TEST_CASE("of luminaires in one place the first one along the ray is seen", "[world]") {
    const std::string lamp = " pigment { rgb 1 } finish { diffuse 0 emission ";
    const SharedWorld nested = world_of(surface_below + "sphere { 0, 1 - 1e-7" + lamp +
                                        "900 } } sphere { 0, 1" + lamp + "2 } }");
    CHECK(seen_along(*nested, Vec3(0, 9, 0), Vec3(0)) == Rgb(0));
    CHECK(seen_along(*nested, Vec3(0, 9, 0), Vec3(0), 1) == Rgb(2));
    const SharedWorld twice =
        world_of(surface_below + "sphere { 0, 1" + lamp + "3 } } sphere { 0, 1" + lamp + "5 } }");
    CHECK(seen_along(*twice, Vec3(1, 9, 2), Vec3(0)) == Rgb(3));
    CHECK(seen_along(*twice, Vec3(1, 9, 2), Vec3(0), 1) == Rgb(0));
    const SharedWorld covered = world_of(surface_below + "disc { 0, y, 1" + lamp +
                                         "3 } } plane { y, 1e-8 pigment { rgb 1 } }");
    CHECK(seen_along(*covered, Vec3(0, 9, 0), Vec3(0)) == Rgb(0));
    // A clear surface lets it through.
    const SharedWorld behind = world_of(surface_below + "sphere { 0, 1" + lamp +
                                        "4 } } sphere { 0, 1 + 1e-8 pigment { rgbt 0.5 } }");
    CHECK(seen_along(*behind, Vec3(0, 9, 0), Vec3(0)).r == Approx(2));
}

TEST_CASE("the far side of a luminaire is not its near side, however far it is", "[world]") {
    const SharedWorld world = world_of(
        "#version 3.7; torus { 3, 1 translate 1e8*z "
        "pigment { rgb 1 } finish { emission 2 } }");
    const Luminaire& ring = world->lights.luminaires.own().at(0);
    const Ray ray{Vec3(3, 0, 0), Vec3(0, 0, 1)};
    CHECK(radiance_seen(*world, ring, {ray, 0, 1e8 - std::sqrt(7)}) == Rgb(2));
    CHECK(radiance_seen(*world, ring, {ray, 0, 1e8 + std::sqrt(7)}) == Rgb(0));
}

}  // namespace candelabra
