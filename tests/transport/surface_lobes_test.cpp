// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/surface_lobes.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <map>
#include <string>

namespace candelabra {

namespace {

/// Calls use(lobes, path) at the sphere of radius 1 around the origin, met from above at an angle.
template <class Use>
void at_sphere(const std::string& look, const Use& use, bool taken = true) {
    const SharedWorld world =
        world_of("#version 3.7; global_settings { integrator { path_traced } } sphere { 0, 1 " +
                 look + " }");
    PathState path;
    path.ray = {Vec3(0.6, 4, 0), Vec3(0, -1, 0)};
    path.taken.by_shadow_rays = taken;
    Hit hit;
    REQUIRE(world->first_hit(path.ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(*world, path.ray, hit);
    const auto textures = visible_textures(*world, vertex);
    const LayerStack stack(*world, path, vertex, textures.front().layers);
    const ShadingRules rules = shading_rules(*world);
    SurfaceLobes lobes(*world, rules, path, vertex, stack);
    stack.visit([&](const LayerStack::Seen& layer) { lobes.add(layer, {}); });
    lobes.add_behind();
    use(lobes, path);
}

}  // namespace

TEST_CASE("lobes are chosen in proportion to their shares", "[transport]") {
    const std::string look =
        "pigment { rgbt <1, 1, 1, 0.4> } finish { diffuse 0.5 reflection 0.2 } interior { ior 1.2 "
        "}";
    at_sphere(look, [](const SurfaceLobes& lobes, const PathState&) {
        std::map<LobeKind, double> found;
        constexpr int count = 1000;
        for (int i = 0; i < count; ++i) {
            const auto choice = lobes.choose((i + 0.5) / count);
            REQUIRE(choice);
            found[choice->lobe.kind] += 1.0 / count;
            CHECK(choice->chance > 0);
        }
        // The mirror has 0.2, the diffuse part 0.5 of the opaque 0.6, and 0.4 come from behind.
        CHECK(found[LobeKind::mirror] == Approx(0.2 / 0.9).margin(0.002));
        CHECK(found[LobeKind::diffuse] == Approx(0.3 / 0.9).margin(0.002));
        CHECK(found[LobeKind::behind] == Approx(0.4 / 0.9).margin(0.002));
        CHECK(found.size() == 3);
    });
}

TEST_CASE("a surface without lobes ends paths", "[transport]") {
    at_sphere("pigment { rgb 0 } finish { diffuse 0 }",
              [](const SurfaceLobes& lobes, const PathState&) { CHECK_FALSE(lobes.choose(0.5)); });
}

TEST_CASE("paths go on along their lobe, and say what shadow rays have taken", "[transport]") {
    const auto next_of = [](const std::string& look, LobeKind kind, bool taken = true) {
        PathState found;
        const auto use = [&](const SurfaceLobes& lobes, const PathState& path) {
            const auto choice = lobes.choose(0);
            REQUIRE(choice);
            CHECK(choice->lobe.kind == kind);
            found = path;
            REQUIRE(lobes.follow(choice->lobe, found));
        };
        at_sphere(look, use, taken);
        return found;
    };
    // The normal is <0.6, 0.8, 0>.
    const PathState mirror =
        next_of("pigment { rgb 0 } finish { diffuse 0 reflection 1 }", LobeKind::mirror);
    CHECK(length(mirror.ray.direction - Vec3(0.96, 0.28, 0)) < 1e-9);
    CHECK_FALSE(mirror.taken.by_shadow_rays);
    CHECK(mirror.depth == 1);
    const PathState straight = next_of("pigment { rgbt 1 }", LobeKind::behind);
    CHECK(straight.ray.direction == Vec3(0, -1, 0));
    CHECK(straight.taken.by_shadow_rays);
    CHECK(straight.depth == 0);
    CHECK(straight.passed == 1);
    const PathState bent = next_of("pigment { rgbt 1 } interior { ior 1.5 }", LobeKind::behind);
    CHECK(bent.ray.direction.x < -0.1);
    CHECK(bent.depth == 1);
    CHECK(bent.media.size() == 1);
    // Light that would come out of a denser medium is reflected.
    const std::string thinner = "pigment { rgbt 1 } interior { ior 0.5 }";
    const PathState total = next_of(thinner, LobeKind::total, false);
    CHECK(length(total.ray.direction - Vec3(0.96, 0.28, 0)) < 1e-9);
    CHECK(total.media.empty());
    // Shadow rays go straight on there, and so does what they leave to the path.
    const PathState taken = next_of(thinner, LobeKind::total);
    CHECK(taken.ray.direction == Vec3(0, -1, 0));
    CHECK(taken.taken.by_shadow_rays);
    CHECK(taken.media.size() == 1);
    const PathState diffuse =
        next_of("pigment { rgb 0.5 } finish { diffuse 1 }", LobeKind::diffuse);
    CHECK(diffuse.taken.by_shadow_rays);
    CHECK(diffuse.bounces == 1);
    CHECK(diffuse.throughput.r == Approx(0.5));
}

}  // namespace candelabra
