// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/body_web.h"

#include "photometry/web_table.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

AimedWeb axial(std::vector<double> vertical, std::vector<double> candela) {
    PhotometricWeb web;
    std::string symmetry;
    std::vector<std::string> notes;
    REQUIRE(complete_table({WebType::c, std::move(vertical), {0}, std::move(candela)}, web,
                           symmetry, notes) == "");
    WebPlace place;
    place.web = make_handle<PhotometricWeb>(std::move(web));
    return AimedWeb(place);
}

std::vector<Facet> ball(int count) {
    std::vector<Facet> facets;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - (2 * i + 1.0) / count, angle = 2.399963 * i,
                     across = std::sqrt(1 - y * y);
        facets.push_back({{across * std::cos(angle), y, across * std::sin(angle)},
                          4 * std::numbers::pi / count});
    }
    return facets;
}

Vec3 below(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::sin(angle), -std::cos(angle), 0};
}

}  // namespace

TEST_CASE("the radiance of a body times the area that faces a direction is the intensity there",
          "[luminaire]") {
    const AimedWeb web = axial({0, 30, 60, 90}, {300, 250, 120, 0});
    SECTION("a disc that shines down") {
        const BodyWeb disc(web, {{{0, -1, 0}, 2}});
        for (const double angle : {0.0, 20.0, 60.0, 85.0})
            CHECK(disc.factor(below(angle)) * 2 * std::cos(angle * std::numbers::pi / 180) ==
                  Approx(web.intensity(below(angle))));
        CHECK(disc.factor(below(120)) == 0);
    }
    SECTION("a ball shows the same area everywhere") {
        const BodyWeb round(web, ball(2000));
        for (const double angle : {0.0, 20.0, 60.0, 85.0})
            CHECK(round.factor(below(angle)) * std::numbers::pi ==
                  Approx(web.intensity(below(angle))).epsilon(0.02));
    }
    SECTION("a long body shows its sides") {
        // Half a ball and a wall: many normals that are not alike from all sides.
        std::vector<Facet> facets = ball(1000);
        facets.push_back({{1, 0, 0}, 20});
        const BodyWeb body(web, facets);
        CHECK(body.factor(below(45)) * (std::numbers::pi + 20 * std::sqrt(0.5)) ==
              Approx(web.intensity(below(45))).epsilon(0.02));
    }
}

TEST_CASE("the bounds of a body's web hold", "[luminaire]") {
    const AimedWeb web = axial({0, 3, 5, 90}, {1000, 1000, 0, 10});
    for (const std::vector<Facet>& facets :
         {std::vector<Facet>{{{0, -1, 0}, 1}, {{0, 1, 0}, 1}}, ball(500)}) {
        const BodyWeb body(web, facets);
        double greatest = 0, sum = 0;
        for (int i = 0; i < 100000; ++i) {
            const double y = 1 - (2 * i + 1.0) / 100000, angle = 2.399963 * i,
                         across = std::sqrt(1 - y * y);
            const double factor =
                body.factor({across * std::cos(angle), y, across * std::sin(angle)});
            greatest = std::max(greatest, factor);
            sum += factor / 100000;
        }
        CHECK(greatest <= body.greatest());
        CHECK(body.greatest() < 1.3 * greatest);
        CHECK(body.mean_share() == Approx(sum / greatest).epsilon(0.15));
    }
}

}  // namespace candelabra
