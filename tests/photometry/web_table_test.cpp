// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/web_table.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct CompletedTable {
    PhotometricWeb web;
    std::string symmetry, problem;
    std::vector<std::string> notes;
};

/// A table whose plane number n has n + 1 candela at each angle but the poles, where it has 5.
CompletedTable of_planes(std::vector<double> planes, WebType type = WebType::c) {
    WebTable table{
        type,
        type == WebType::c ? std::vector<double>{0, 90, 180} : std::vector<double>{-90, 10, 90},
        std::move(planes),
        {}};
    for (std::size_t i = 0; i < table.horizontal.size(); ++i)
        for (const double each : {5.0, static_cast<double>(i + 1), 5.0})
            table.candela.push_back(each);
    CompletedTable made;
    made.problem = complete_table(std::move(table), made.web, made.symmetry, made.notes);
    return made;
}

double around(const CompletedTable& made, double angle) {
    return made.web.intensity(WebAngles{90, angle});
}

}  // namespace

TEST_CASE("planes over a part of the circle are mirrored", "[photometry]") {
    struct Case {
        std::vector<double> planes;
        const char* symmetry;
        /// Horizontal angles that show the last plane, and those of the first.
        std::vector<double> last, first;
        std::size_t notes;
    };
    const Case cases[] = {
        {{0}, "axial", {0, 123}, {300}, 0},
        {{45}, "axial", {0, 123}, {300}, 1},
        {{0, 90}, "quadrant", {90, 270, -90}, {0, 180, 360}, 0},
        {{90, 135, 180}, "quadrant", {0, 180}, {90, 270}, 0},
        {{0, 90, 180}, "bilateral 0-180", {180}, {0, 360}, 0},
        {{90, 180, 270}, "bilateral 90-270", {270, -90}, {90}, 0},
        {{-90, 0, 90}, "bilateral 90-270", {90}, {270}, 0},
        {{180, 270, 360}, "bilateral 0-180", {0, 360}, {180}, 0},
        {{30, 120, 210}, "bilateral 30-210", {210}, {30}, 0},
        {{0, 90, 180, 270}, "none", {270}, {0, 360}, 1},
        {{0, 120, 240}, "none", {240}, {0}, 1},
    };
    for (const Case& each : cases) {
        const CompletedTable made = of_planes(each.planes);
        CAPTURE(each.symmetry, each.planes.size());
        REQUIRE(made.problem == "");
        CHECK(made.symmetry == each.symmetry);
        CHECK(made.notes.size() == each.notes);
        for (const double angle : each.last)
            CHECK(around(made, angle) == Approx(each.planes.size()));
        for (const double angle : each.first) CHECK(around(made, angle) == Approx(1));
    }
    // Between mirrored planes, too.
    const CompletedTable mirrored = of_planes({90, 180, 270});
    CHECK(around(mirrored, 45) == Approx(around(mirrored, 135)));
    CHECK(around(mirrored, 330) == Approx(around(mirrored, 210)));
}

TEST_CASE("planes that fit no symmetry are refused", "[photometry]") {
    for (const std::vector<double>& planes :
         {std::vector<double>{0, 45}, std::vector<double>{0, 60, 120},
          std::vector<double>{0, 200, 400}})
        CHECK(of_planes(planes).problem.find("a symmetry has planes over 90 or 180 degrees") !=
              std::string::npos);
}

TEST_CASE("the first and the last plane of a full circle are one", "[photometry]") {
    const CompletedTable made = of_planes({0, 90, 180, 270, 360});
    CHECK(made.notes.size() == 1);
    CHECK(around(made, 360) == Approx(1));
    CHECK(around(made, 315) == Approx(2.5));
}

TEST_CASE("all planes agree straight down and up", "[photometry]") {
    PhotometricWeb web;
    std::string symmetry;
    std::vector<std::string> notes;
    REQUIRE(complete_table(
                {WebType::c, {0, 90}, {0, 90, 180, 270, 360}, {10, 1, 20, 1, 30, 1, 40, 1, 10, 1}},
                web, symmetry, notes) == "");
    CHECK(web.intensity(Vec3(0, 0, -1)) == Approx(25));
    REQUIRE(notes.size() == 1);
    CHECK(notes[0] == "the planes differ at 0 degrees, from 10 to 40 cd: their mean is taken");
}

TEST_CASE("tables of beams are mirrored where they begin at 0", "[photometry]") {
    for (const WebType type : {WebType::a, WebType::b}) {
        const CompletedTable made = of_planes({0, 45, 90}, type);
        REQUIRE(made.problem == "");
        CHECK(made.symmetry == "lateral");
        for (const double side : {-45.0, 45.0})
            CHECK(made.web.intensity(WebAngles{10, side}) == Approx(2));
        CHECK(of_planes({-90, 0, 90}, type).symmetry == "none");
        CHECK(of_planes({0}, type).problem != "");
        PhotometricWeb web;
        std::string symmetry;
        std::vector<std::string> notes;
        REQUIRE(complete_table({type, {0, 90}, {0, 90}, {9, 4, 3, 1}}, web, symmetry, notes) == "");
        CHECK(symmetry == "quadrant");
        CHECK(notes.size() == 1);
        for (const double up : {-90.0, 90.0})
            for (const double side : {-90.0, 90.0})
                CHECK(web.intensity(WebAngles{up, side}) == Approx(1));
    }
}

}  // namespace candelabra
