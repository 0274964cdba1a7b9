// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/path_steps.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The vertex where the path's ray meets the world.
Vertex met_from(const World& world, const PathState& path) {
    Hit hit;
    REQUIRE(world.first_hit(path.ray, 0, RayKind::camera, hit));
    return vertex_at(world, path.ray, hit);
}

}  // namespace

TEST_CASE("a path begins inside of what is around its origin", "[transport]") {
    const Shot shot =
        shot_of("camera { location 0 } sphere { 0, 2 pigment { rgbt 1 } interior { ior 1.3 } }");
    PathEnds ends(shot, false, false);
    const PathState path = ends.begin({Vec3(0), Vec3(0, 0, 1)}, Key());
    CHECK(path.media.size() == 1);
    CHECK(path.throughput == Rgb(1));
    CHECK(path.kind == RayKind::camera);
}

TEST_CASE("what is clear counts until the next sample", "[transport]") {
    const Shot shot = shot_of("#version 3.7; background { rgbt <0.5, 0.5, 0.5, 1> }");
    PathEnds ends(shot, true, false);
    LightLedger ledger;
    for (int sample = 0; sample < 2; ++sample) {
        PathState path = ends.begin({Vec3(0), Vec3(0, 0, 1)}, Key());
        CHECK(ends.clear() == 0);
        path.dim(Rgb(0.25));
        ends.background(path, ledger);
        CHECK(ends.clear() == Approx(0.25 * shot.world->sky_clear(path.ray.direction)));
    }
}

TEST_CASE("luminaires that were asked before show no emission", "[transport]") {
    const SharedWorld world = world_of(R"(
        sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
        sphere { 3, 1 pigment { rgb 1 } finish { emission 1 no_luminaire } })");
    PathState path;
    CHECK(shows_emission(*world, path, 0));
    path.taken.by_shadow_rays = true;
    CHECK_FALSE(shows_emission(*world, path, 0));
    CHECK(shows_emission(*world, path, 1));
}

TEST_CASE("steps from a surface leave it on the side that is seen", "[transport]") {
    const SharedWorld world = world_of(
        "plane { -z, 0 pigment { rgb 1 } finish { microfacet { roughness 0.6 metallic 1 } } }");
    PathState path;
    path.ray = {Vec3(0, 0, -3), unit(Vec3(0.3, 0.2, 1))};
    path.taken.by_shadow_rays = true;
    path.depth = 2;
    const Vertex vertex = met_from(*world, path);
    for (const auto& [weight, layers] : visible_textures(*world, vertex)) {
        const Shading s = with_layer(*world, vertex, layers.front());
        const PathState mirror = mirrored_path(path, vertex, s);
        CHECK(mirror.ray.direction.z == Approx(-path.ray.direction.z));
        CHECK(mirror.depth == 3);
        CHECK_FALSE(mirror.taken.by_shadow_rays);
        const PathState gathers = gathering_path(path, vertex, Vec3(0, 0, -1));
        CHECK(gathers.depth == 0);
        CHECK(gathers.bounces == 1);
        CHECK(gathers.taken.by_shadow_rays);
        CHECK(gathers.kind == RayKind::gathering);
        int scattered = 0;
        for (path.key.sample = 0; path.key.sample < 100; ++path.key.sample)
            if (const auto facets = facet_path(path, vertex, s)) {
                ++scattered;
                CHECK(facets->next.ray.direction.z < 0);
                CHECK(facets->next.throughput == facets->share);
            }
        CHECK(scattered > 50);
    }
}

}  // namespace candelabra
