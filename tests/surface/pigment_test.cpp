// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pigment.h"

#include "support/script.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Pigment pigment_of(const std::string& text) {
    const Script done = run("#version 3.7; sphere { 0, 1 pigment { " + text + " } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    return done.texture().pigment;
}

double red(const Pigment& pigment, double x) { return evaluate(pigment, Vec3(x, 0, 0)).rgb.r; }

constexpr const char* ramp = "color_map { [0 rgb 0] [1 rgb 1] }";

}  // namespace

TEST_CASE("a pattern is looked up in the space before the pigment's transform", "[surface]") {
    CHECK(evaluate(pigment_of("gradient x scale 2"), Vec3(0.5, 7, 7)).rgb.r == Approx(0.25));
}

TEST_CASE("a pigment map mixes pigments at the warped point", "[surface]") {
    const Pigment plain = pigment_of("gradient x pigment_map { [0 rgb 0] [0.5 rgb 1] [1 rgb 3] }");
    CHECK(red(plain, 0.25) == Approx(0.5));
    CHECK(red(plain, 0.75) == Approx(2));
    const Pigment nested =
        pigment_of("gradient x pigment_map { [0.5 gradient x scale 0.5] [0.5 rgb 7] } scale 2");
    CHECK(red(nested, 0.5) == Approx(0.5));
    CHECK(red(nested, 1.5) == Approx(7));
}

TEST_CASE("average mixes all by their weights", "[surface]") {
    const Pigment pigment =
        pigment_of("average pigment_map { [1 rgb 1] [3 rgbt <5, 0, 0, 1>] [0 rgb 99] }");
    const Colour colour = evaluate(pigment, Vec3(0));
    CHECK(colour.rgb.r == Approx(4));
    CHECK(colour.rgb.g == Approx(0.25));
    CHECK(colour.transmit == Approx(0.75));
}

TEST_CASE("lists of pigments stand for their places", "[surface]") {
    const Pigment pigment = pigment_of("checker pigment { rgb 2 } pigment { gradient x }");
    CHECK(red(pigment, 0.5) == Approx(2));
    CHECK(red(pigment, 1.25) == Approx(0.25));
}

TEST_CASE("a pigment_pattern has the brightness of its pigment", "[surface]") {
    const Pigment pigment = pigment_of(
        "pigment_pattern { gradient x color_map { [0 rgb 0] "
        "[1 rgb <0.5, 0, 1>] } } " +
        std::string(ramp) + " scale 2");
    CHECK(red(pigment, 1) == Approx(0.5 * (0.297 * 0.5 + 0.114)));
}

TEST_CASE("brightest and transparent look at everything in it", "[surface]") {
    CHECK(brightest(pigment_of("rgb <0.5, 2, 0>")) == Rgb(0.5, 2, 0));
    CHECK_FALSE(transparent(pigment_of("rgb 1")));
    CHECK_FALSE(transparent(pigment_of("checker rgb 1 rgb 0")));
    const Pigment mixed = pigment_of("checker rgb x rgbt <0, 3, 0, 0.5>");
    CHECK(brightest(mixed) == Rgb(1, 3, 0));
    CHECK(transparent(mixed));
    const Pigment nested = pigment_of(
        "gradient x pigment_map { [0 rgb 1] [1 checker pigment { rgbf <5, 0, 0, 1> } ] }");
    CHECK(brightest(nested) == Rgb(5, 1, 1));
    CHECK(transparent(nested));
}

TEST_CASE("nesting counts maps within maps", "[surface]") {
    CHECK(nesting(pigment_of("rgb 1")).depth == 0);
    CHECK(nesting(pigment_of("gradient x")).depth == 1);
    const Nesting nested = nesting(pigment_of(
        "gradient x pigment_map { [0 gradient x] [0 pigment_pattern { gradient x }] [1 rgb 1] }"));
    CHECK(nested.depth == 3);
    CHECK(nested.entries == 2 + 4 + 1);
    CHECK_FALSE(nested.too_deep());
}

TEST_CASE("a pigment knows whether it looks different from elsewhere", "[surface]") {
    struct Row {
        const char* pigment;
        bool by_view;
    };
    const Row rows[] = {{"rgb 1", false},
                        {"slope { y }", false},
                        {"aoi", true},
                        {"average pigment_map { [1 rgb 1] [1 aoi] }", true},
                        {"pigment_pattern { aoi } color_map { [0 rgb 0] [1 rgb 1] }", true},
                        {"gradient x pigment_map { [0 pigment_pattern { aoi }] [1 rgb 1] }", true}};
    for (const Row& row : rows) {
        CAPTURE(row.pigment);
        CHECK(nesting(pigment_of(row.pigment)).by_view == row.by_view);
    }
}

}  // namespace candelabra
