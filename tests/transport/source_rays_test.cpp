// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/source_rays.h"

#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

const LitRegion region{Vec3(0), 1, 1e5};

/// Light of all sources that arrives at a disc around 0, which faces the camera's side.
double light_on_disc(const std::string& sources, double radius) {
    const SharedWorld world =
        world_of("#version 3.7; plane { y, -9 pigment { rgb 1 } } " + sources);
    const SourceRays rays(world->lights.sources, region);
    Draw draw(3);
    double sum = 0;
    constexpr int count = 200000;
    for (int i = 0; i < count; ++i) {
        const auto drawn = rays.draw(draw.number(), {draw.number(), draw.number()});
        const Ray& ray = drawn.ray.ray;
        const double way = -ray.origin.y / ray.direction.y;
        const Vec3 point = ray.at(way);
        if (!(way > 0) || length(point) > radius) continue;
        const Rgb power = drawn.ray.power_after(way);
        sum += power.r / count;
    }
    return sum;
}

}  // namespace

TEST_CASE("rays of sources bring all of their light, near the region and far from it",
          "[transport]") {
    // Light of colour 3 that does not fade: on a disc, colour times area times the mean cosine.
    const auto of_point = [](double height, double radius) {
        double sum = 0;
        constexpr int rings = 1000;
        for (int i = 0; i < rings; ++i) {
            const double away = radius * (i + 0.5) / rings;
            sum += 3 * 2 * pi * away * (radius / rings) * height / std::hypot(height, away);
        }
        return sum;
    };
    struct Row {
        const char* sources;
        double height;
    };
    for (const Row& row :
         {Row{"light_source { 0.5*y, rgb 3 }", 0.5}, Row{"light_source { 4*y, rgb 3 }", 4},
          Row{"light_source { 3e8*y, rgb 3 }", 3e8}})
        for (const double radius : {0.5, 1.0, 6.0}) {
            CAPTURE(row.sources, radius);
            CHECK(light_on_disc(row.sources, radius) ==
                  Approx(of_point(row.height, radius)).epsilon(0.05));
        }
}

TEST_CASE("parallel rays, cones and cylinders bring their light, and each source its own",
          "[transport]") {
    const double area = pi * 4;
    const std::string sun = "light_source { <0, 50, 0>, rgb 3 parallel point_at 0 } ",
                      dim = "light_source { <0, 20, 0>, rgb 0.01 parallel point_at 0 } ",
                      cylinder =
                          "light_source { <0, 5, 0>, rgb 2 cylinder point_at 0 radius 0.5 "
                          "falloff 0.5 } ",
                      spot =
                          "light_source { <0, 10, 0>, rgb 2 spotlight point_at 0 radius 1 "
                          "falloff 1 } ";
    CHECK(light_on_disc(sun, 2) == Approx(3 * area).epsilon(0.03));
    CHECK(light_on_disc(sun + dim, 2) == Approx(3.01 * area).epsilon(0.03));
    CHECK(light_on_disc(dim, 2) == Approx(0.01 * area).epsilon(0.03));
    CHECK(light_on_disc(cylinder, 2) == Approx(2 * pi * 0.25).epsilon(0.03));
    const double wide = 10 * std::tan(pi / 180);
    const std::string inside_out =
        "light_source { <0, 10, 0>, rgb 2 spotlight point_at 0 radius 1 falloff 0.2 } ";
    CHECK(light_on_disc(inside_out, 2) == Approx(2 * pi * wide * wide).epsilon(0.03));
    CHECK(light_on_disc(spot, 2) == Approx(2 * pi * wide * wide).epsilon(0.03));
}

TEST_CASE("sources without light are not drawn", "[transport]") {
    const SharedWorld dark =
        world_of("#version 3.7; plane { y, -9 pigment { rgb 1 } } light_source { 3*y, rgb 0 }");
    CHECK(SourceRays(dark->lights.sources, region).power() == 0);
    CHECK(SourceRays({}, region).power() == 0);
}

}  // namespace candelabra
