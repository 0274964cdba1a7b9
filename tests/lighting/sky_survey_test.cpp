// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/sky_survey.h"

#include "support/painted_sky.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

constexpr auto nothing_there = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };

std::vector<SurveyPlace> places_facing(const Vec3& normal, Horizon horizon) {
    return std::vector<SurveyPlace>(5, SurveyPlace{{Vec3(0), normal, horizon}, 1e-9});
}

}  // namespace

TEST_CASE("the survey of a sky finds its irradiance on surfaces of each direction", "[lighting]") {
    // The irradiance of luminance 2 + y is 2 pi + 2/3 pi times the height of the normal.
    const PaintedSky sky;
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, -1)}) {
        const auto places = places_facing(normal, Horizon::one_side);
        const SkySurvey found(sky, rays_to_sky(sky, places, nothing_there));
        const double expected = 2 * pi + 2.0 / 3 * pi * normal.y;
        CAPTURE(normal.x, normal.y, normal.z);
        CHECK(found.there().mean == Approx(expected).epsilon(0.15));
        CHECK(found.at({Vec3(0), normal, Horizon::one_side}).mean == Approx(expected).epsilon(0.2));
        CHECK(found.there().root >= found.there().mean);
        CHECK(found.there().root < 2 * found.there().mean);
    }
    const auto in_air = places_facing(Vec3(0), Horizon::none);
    CHECK(SkySurvey(sky, rays_to_sky(sky, in_air, nothing_there)).at(in_air[0].point).mean ==
          Approx(8 * pi).epsilon(0.15));
    const auto both = places_facing(Vec3(1, 0, 0), Horizon::both_sides);
    CHECK(SkySurvey(sky, rays_to_sky(sky, both, nothing_there)).at(both[0].point).mean ==
          Approx(4 * pi).epsilon(0.25));
}

TEST_CASE("no light of a sky arrives behind walls, and half of it behind grey glass",
          "[lighting]") {
    const PaintedSky sky;
    const auto places = places_facing(Vec3(0, 1, 0), Horizon::one_side);
    const auto behind = [&](double passes) {
        const auto pane = [&](const Ray& ray, double tolerance) -> std::optional<ProbeHit> {
            if (tolerance >= 1) return {};
            return ProbeHit{1, -ray.direction, 1e-9, {}, 0, passes};
        };
        return SkySurvey(sky, rays_to_sky(sky, places, pane)).there().mean;
    };
    CHECK(behind(0) == 0);
    CHECK(behind(0.5) == Approx(0.5 * behind(1)).epsilon(1e-9));
    CHECK(behind(1) > 1);
}

TEST_CASE("of two surveys of a sky, that with more light counts", "[lighting]") {
    const PaintedSky sky;
    const auto places = places_facing(Vec3(0, 1, 0), Horizon::one_side);
    const SkySurvey lit(sky, rays_to_sky(sky, places, nothing_there)), dark;
    for (const SkySurvey& each : {brighter(lit, dark), brighter(dark, lit)}) {
        CHECK(each.there().mean == lit.there().mean);
        CHECK(each.there().root == lit.there().root);
        CHECK(each.at(places[0].point).mean == lit.at(places[0].point).mean);
    }
}

TEST_CASE("one draw goes to the sky as often as makes the least noise", "[lighting]") {
    const auto noise_with = [](double share, const DrawnLight& sky, const DrawnLight& lamps) {
        const double mean = sky.mean + lamps.mean;
        return (sky.root * sky.root / share + lamps.root * lamps.root / (1 - share)) /
                   (mean * mean) -
               1;
    };
    const DrawnLight sky{2, 3}, lamps{5, 9};
    const SharedDraw best = shared_draw(sky, lamps);
    CHECK(best.mean == 7);
    CHECK(best.noise == Approx(noise_with(best.sky, sky, lamps)));
    for (const double off : {-0.02, 0.02})
        CHECK(best.noise < noise_with(best.sky + off, sky, lamps));
}

TEST_CASE("neither the sky nor lamps lose their chance where a survey finds none", "[lighting]") {
    const DrawnLight none, some{1, 2};
    for (const SharedDraw& each :
         {shared_draw(none, some), shared_draw(some, none), shared_draw(none, none)}) {
        CHECK(each.sky >= 0.2);
        CHECK(each.sky <= 0.8);
    }
    CHECK(shared_draw(some, {}).sky == 1);
    CHECK(shared_draw(none, {}).sky == 1);
    CHECK(shared_draw(some, {}).noise == Approx(3));
}

}  // namespace candelabra
