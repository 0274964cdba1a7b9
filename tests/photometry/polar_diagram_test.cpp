// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/polar_diagram.h"

#include "photometry/web_table.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

PhotometricFile of(WebTable table, int version) {
    PhotometricFile file;
    file.version = version;
    REQUIRE(complete_table(std::move(table), file.web, file.symmetry, file.notes) == "");
    return file;
}

/// A lamp of I0 cos V, twice as strong in the planes 90 and 270 as in 0 and 180.
PhotometricFile lamp(int version) {
    return of({WebType::c, {0, 60, 90}, {0, 90}, {100, 50, 0, 100, 100, 0}}, version);
}

}  // namespace

TEST_CASE("the two sections cross at right angles and are named as the format does",
          "[photometry]") {
    const PhotometricFile file = lamp(2002);
    const auto sections = sections_of(file);
    CHECK(sections[0].name.starts_with("0-180"));
    CHECK(sections_of(lamp(0))[0].name.starts_with("C0-C180, across"));
    CHECK(intensity_in(file.web, sections[0], 60) == Approx(50));
    CHECK(intensity_in(file.web, sections[0], -60) == Approx(50));
    CHECK(intensity_in(file.web, sections[1], 60) == Approx(100));
    CHECK(intensity_in(file.web, sections[1], 300) == Approx(100));
    const PhotometricFile beam =
        of({WebType::a, {-90, 0, 90}, {-90, 0, 90}, {0, 0, 0, 0, 9, 0, 0, 0, 0}}, 2002);
    for (const WebSection& section : sections_of(beam)) {
        CHECK(intensity_in(beam.web, section, 0) == Approx(9));
        CHECK(intensity_in(beam.web, section, 45) == Approx(4.5));
    }
}

TEST_CASE("the width of a beam is that of a share of its maximum", "[photometry]") {
    const PhotometricFile file = lamp(2002);
    const auto sections = sections_of(file);
    CHECK(width_of_beam(file.web, sections[0], 0.5) == Approx(120).margin(0.2));
    CHECK(width_of_beam(file.web, sections[0], 0.1) == Approx(2 * 84).margin(0.2));
    CHECK(width_of_beam(file.web, sections[1], 0.5) == Approx(150).margin(0.2));
    const PhotometricFile even = of({WebType::c, {0, 180}, {0}, {7, 7}}, 2002);
    CHECK(width_of_beam(even.web, sections[0], 0.5) == 360);
    const PhotometricFile dark = of({WebType::c, {0, 180}, {0}, {0, 0}}, 2002);
    CHECK(width_of_beam(dark.web, sections[0], 0.5) == 0);
}

TEST_CASE("diagrams name their planes, and no text breaks them", "[photometry]") {
    const std::string svg = polar_diagram(lamp(2002), "<b>&.ies");
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(svg.find("&lt;b&gt;&amp;.ies") != std::string::npos);
    for (const WebSection& section : sections_of(lamp(2002)))
        CHECK(svg.find(section.name) != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    const PhotometricFile dark = of({WebType::c, {0, 180}, {0}, {0, 0}}, 2002);
    CHECK(polar_diagram(dark, "dark").find("nan") == std::string::npos);
    const std::string text = polar_text(lamp(2002));
    CHECK(std::ranges::count(text, '\n') == 32);
    CHECK(text.find('@') != std::string::npos);
    CHECK(text.find("o 90-270") != std::string::npos);
}

}  // namespace candelabra
