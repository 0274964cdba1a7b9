// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/shadow_ray.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

namespace candelabra {

namespace {

/// A ray straight up from a floor at the origin.
class Upwards {
public:
    explicit Upwards(const std::string& above)
        : world_(
              world_of("#version 3.7; #default { finish { ambient 0 } } global_settings { "
                       "integrator { path_traced } } box { <-9, -1, -9>, <9, 0, 9> pigment { rgb "
                       "1 } } " +
                       above)) {
        Hit hit;
        const Ray ray{Vec3(0, 0.1, 0), Vec3(0, -1, 0)};
        REQUIRE(world_->first_hit(ray, 0, RayKind::camera, hit));
        vertex_ = vertex_at(*world_, ray, hit);
    }

    template <class Use>
    auto ask(const Use& use) const {
        const auto textures = visible_textures(*world_, vertex_);
        const Shading shading = with_layer(*world_, vertex_, textures.front().layers.front());
        const ShadingRules rules = shading_rules(*world_);
        const Bsdf bsdf(shading, rules);
        const LitLayer layer{vertex_, bsdf, all_light};
        LightLedger ledger;
        const ArrivingLight at{*world_, layer, false, ledger};
        return use(ShadowRay(at, Vec3(0, 1, 0), Key()));
    }
    double left(double distance) const {
        return ask([&](const ShadowRay& ray) { return ray.left(distance).r; });
    }
    double left_from_sky() const {
        return ask([](const ShadowRay& ray) { return ray.left_from_sky().r; });
    }
    double left_by_air(double distance) const {
        return ask([&](const ShadowRay& ray) { return ray.left_by_air(distance, 1e-9).r; });
    }
    double emitted(LightIndex light, double distance) const {
        return ask([&](const ShadowRay& ray) {
            return world_->lights.visit(
                light, [&](const auto& glowing) { return ray.emitted(glowing, distance).r; });
        });
    }

private:
    SharedWorld world_;
    Vertex vertex_;
};

const std::string pane = "box { <-2, 1, -2>, <2, 1.1, 2> pigment { rgbt <1, 1, 1, 0.5> } } ";
const std::string wall = "box { <-2, 1, -2>, <2, 1.1, 2> pigment { rgb 1 } } ";
const std::string lamp =
    "sphere { <0, 4, 0>, 1 pigment { rgb 1 } finish { diffuse 0 emission 2 } } ";

}  // namespace

TEST_CASE("a shadow ray has what surfaces, media and fog leave up to its end", "[transport]") {
    CHECK(Upwards("").left(3) == 1);
    CHECK(Upwards(wall).left(3) == 0);
    CHECK(Upwards(wall).left(0.9) == 1);
    CHECK(Upwards(pane).left(3) == Approx(0.25));
    CHECK(Upwards("fog { distance 3 }").left(3) == Approx(std::exp(-1)));
    CHECK(Upwards("media { absorption 0.2 }").left(3) == Approx(std::exp(-0.6)));
    // There is no fog in the pane, which is not hollow.
    CHECK(Upwards(pane + "fog { distance 3 }").left(3) == Approx(0.25 * std::exp(-2.9 / 3)));
    CHECK(Upwards("").left_from_sky() == 1);
    CHECK(Upwards(wall).left_from_sky() == 0);
    CHECK(Upwards(pane).left_from_sky() == Approx(0.25));
    CHECK(Upwards("fog { distance 3 }").left_from_sky() == 0);
}

TEST_CASE("clear surfaces are in the way of reflected luminaires, and air dims them",
          "[transport]") {
    CHECK(Upwards("").left_by_air(3) == 1);
    CHECK(Upwards(pane).left_by_air(3) == 0);
    CHECK(Upwards(pane).left_by_air(0.9) == 1);
    CHECK(Upwards("fog { distance 3 }").left_by_air(3) == Approx(std::exp(-1)));
}

TEST_CASE("a shadow ray sees a lamp only where nothing else covers it in its place",
          "[transport]") {
    CHECK(Upwards(lamp).emitted(0, 3) == 2);
    CHECK(Upwards(lamp + "disc { <0, 3 - 1e-8, 0>, y, 2 pigment { rgb 1 } }").emitted(0, 3) == 0);
    // A lamp that casts no shadow dims its own far side alone.
    const std::string ball =
        "sphere { <0, 4, 0>, 1 pigment { rgbt <1, 1, 1, 0.5> } finish { diffuse 0 emission 2 } ";
    const Upwards solid(ball + "}"), ghost(ball + "no_shadow }");
    CHECK(solid.left(5) * solid.emitted(0, 5) == Approx(0.5 * solid.emitted(0, 3)));
    CHECK(ghost.left(5) == 1);
    CHECK(ghost.emitted(0, 5) == Approx(0.5 * ghost.emitted(0, 3)));
}

}  // namespace candelabra
