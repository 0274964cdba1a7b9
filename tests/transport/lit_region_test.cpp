// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lit_region.h"

#include "base/circle.h"
#include "support/draw.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

LitRegion region_of(const std::string& script) {
    const Shot shot = shot_of(script);
    return LitRegion::of(shot, seen_places(shot));
}

}  // namespace

TEST_CASE("light paths aim at what the camera sees, whatever else the scene has", "[transport]") {
    const std::string room =
        "#version 3.7; camera { location <0, 1, -2> look_at <0, 1, 0> } "
        "box { <-3, 0, -3>, <3, 3, 3> pigment { rgb 1 } } ";
    const LitRegion region = region_of(room);
    CHECK(length(region.centre - Vec3(0, 1.5, 1)) < 2);
    CHECK(region.radius > 1.5);
    CHECK(region.radius < 5.5);
    const LitRegion wide =
        region_of(room + "plane { y, -1 } sphere { 1e6*x, 5 pigment { rgb 1 } }");
    CHECK(wide.centre == region.centre);
    CHECK(wide.radius == region.radius);
    CHECK(wide.upstream > 1e6);
    const LitRegion nothing = region_of("#version 3.7; camera { location 7*x }");
    CHECK(nothing.centre == Vec3(7, 0, 0));
    CHECK(nothing.radius == 1);
}

TEST_CASE("the greatest cosine to a region is that to one of its places", "[transport]") {
    const LitRegion region{.centre = Vec3(1, 0, 2), .radius = 1.5};
    Draw draw(3);
    for (int i = 0; i < 200; ++i) {
        const auto direction = [&] { return at_height(2 * draw.number() - 1, draw.number()); };
        const Vec3 from = region.centre + 8 * draw.number() * direction(), normal = direction();
        double greatest = 0;
        for (int k = 0; k < 2000; ++k)
            greatest = std::fmax(
                greatest, dot(unit(region.centre + region.radius * direction() - from), normal));
        const double found = region.greatest_cosine(from, normal);
        const bool within = length(from - region.centre) < region.radius;
        CHECK(found >= greatest - 1e-12);
        CHECK((found < greatest + 0.05 || within));
        if (within) CHECK(found == 1);
    }
}

TEST_CASE("points about a disc have the density that is stated, far from it as well",
          "[transport]") {
    constexpr double radius = 2;
    const Vec3 axis = unit(Vec3(1, 2, -1));
    Draw draw(4);
    // The mean of 1 / density over the points within a distance is the area there.
    for (const double within : {1.0, 2.0, 3.0, 40.0}) {
        double sum = 0;
        constexpr int count = 200000;
        for (int i = 0; i < count; ++i) {
            const Vec3 point = point_about_disc(axis, radius, {draw.number(), draw.number()});
            CHECK(std::abs(dot(point, axis)) < 1e-9 * (1 + length(point)));
            if (length(point) < within) sum += area_about_disc(length(point), radius) / count;
        }
        CAPTURE(within);
        CHECK(sum == Approx(std::numbers::pi * within * within).epsilon(0.05));
    }
}

}  // namespace candelabra
