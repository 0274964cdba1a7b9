// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/make_picture.h"

#include "text/excerpt.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <string>

namespace candelabra {

namespace {

const std::string red_ball =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1.5 }\n"
    "camera { location -3*z look_at 0 }\n"
    "light_source { <5, 5, -9>, 1 }\n"
    "#debug \"hello\"\n"
    "sphere { 0, 1 pigment { rgb <1, 0, 0> } finish { ambient 0.2 } }\n";

SessionSettings small(const std::string& text) {
    SessionSettings settings;
    settings.source.text = text;
    settings.source.name = "ball";
    settings.render.width = 16;
    settings.render.height = 12;
    settings.render.samples = 1;
    return settings;
}

}  // namespace

TEST_CASE("a text becomes a picture", "[session]") {
    std::string said;
    std::atomic<int> steps = 0;
    Listener listener;
    listener.print = [&](std::string_view text) { said += text; };
    listener.diagnostic = [&](const Diagnostic& each, const SourceStore& sources) {
        said += format(each, sources, false);
    };
    listener.progress = [&](double) { ++steps; };
    const auto picture = make_picture(small(red_ball), listener);
    REQUIRE(picture);
    CHECK(said == "hello");
    CHECK(steps > 0);
    CHECK(picture->gamma == 1.5);
    CHECK(picture->rays.camera == 16 * 12);
    const Rgb middle = picture->image.at(8, 6), corner = picture->image.at(0, 0);
    CHECK(middle.r > 0.1);
    CHECK(middle.g == 0);
    CHECK(corner == Rgb(0));
    const auto again = make_picture(small(red_ball));
    REQUIRE(again);
    CHECK(again->image.pixels == picture->image.pixels);
}

TEST_CASE("an error is told with its place, and there is no picture", "[session]") {
    std::string said;
    Listener listener;
    listener.diagnostic = [&](const Diagnostic& each, const SourceStore& sources) {
        said += format(each, sources, false);
    };
    CHECK_FALSE(make_picture(small("sphere { 0, 1 }\nsphere { 0, red }"), listener));
    INFO(said);
    CHECK(said.find("ball:2:") != said.npos);
}

TEST_CASE("a run that is cancelled makes no picture", "[session]") {
    std::atomic<bool> begun = false;
    Listener at_once, under_way;
    at_once.cancelled = [] { return true; };
    CHECK_FALSE(make_picture(small(red_ball), at_once));
    SessionSettings long_work = small(red_ball);
    long_work.render.samples = 1'000'000;
    under_way.progress = [&](double) { begun = true; };
    under_way.cancelled = [&] { return begun.load(); };
    CHECK_FALSE(make_picture(long_work, under_way));
    CHECK(begun);
    int asked = 0;
    Listener while_evaluated;
    while_evaluated.cancelled = [&] { return ++asked > 3; };
    bool told = false;
    while_evaluated.diagnostic = [&](const Diagnostic&, const SourceStore&) { told = true; };
    CHECK_FALSE(make_picture(small("#while (1) #end"), while_evaluated));
    CHECK(asked > 3);
    CHECK_FALSE(told);
}

}  // namespace candelabra
