// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/webs.h"

#include "scene/dump.h"
#include "support/script.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

/// 100 cd in all directions below the horizontal, without a repair.
const std::string even =
    "IESNA:LM-63-2002\r\n[TEST] 1\r\n[TESTLAB] a\r\n[ISSUEDATE] b\r\n[MANUFAC] c\r\n"
    "TILT=NONE\r\n1 -1 1 2 1 1 2 0 0 0\r\n1 1 10\r\n0 90\r\n0\r\n100 100\r\n";

/// The same with factors for a tilt, of a lamp of that geometry.
std::string tilted(const std::string& geometry) {
    std::string result = even;
    const std::string none = "TILT=NONE\r\n";
    return result.replace(result.find(none), none.size(),
                          "TILT=INCLUDE\r\n" + geometry + "\r\n2\r\n0 90\r\n1 0.8\r\n");
}

Script with_web(const std::string& text, const std::string& file = even) {
    return run("#version 3.7; global_settings { photometry { unit 1 white 1 } } " + text,
               {{"a.ies", file}});
}

}  // namespace

TEST_CASE("a light source with a file has its intensity, its flux, or a stated one",
          "[appearance]") {
    const auto colour_below = [](const std::string& words) {
        const Script done = with_web("light_source { 0, rgb 1 ies \"a.ies\" " + words + " }");
        INFO(done.text);
        REQUIRE(done.text.empty());
        const PointLight& light = done.scene.lights.at(0).light;
        CHECK(incidence(light, Vec3(0), Vec3(0.1, 2, 0)).colour == Rgb(0));
        return incidence(light, Vec3(0), Vec3(0, -2, 0)).colour.g * std::numbers::pi * 4;
    };
    CHECK(colour_below("") == Approx(100));
    CHECK(colour_below("intensity candela(50)") == Approx(50));
    CHECK(colour_below("flux lumen(6.283185307)") == Approx(1));
}

TEST_CASE("axes of a file may begin with a sign", "[appearance]") {
    const Script source = with_web("light_source { 0, 1 ies \"a.ies\" aim -z c0 -x }");
    INFO(source.text);
    REQUIRE(source.text.empty());
    CHECK(source.scene.lights.at(0).light.aim == Vec3(0, 0, -1));
    CHECK(source.scene.lights.at(0).light.c0 == Vec3(-1, 0, 0));
    const Script lamp = with_web(
        "sphere { 0, 1 pigment { rgb 1 } finish { luminaire { ies \"a.ies\" aim -z c0 -x } } }");
    INFO(lamp.text);
    REQUIRE(lamp.text.empty());
    CHECK(lamp.texture().finish.lamp->aim == Vec3(0, 0, -1));
    // Old scenes may have a vector of such a name.
    CHECK(run("#version 3.7; #declare aim = y; light_source { aim - 2*x, 1 }").text.empty());
}

TEST_CASE("lamps of one file share its table", "[appearance]") {
    const Script done = with_web(
        "light_source { 0, 1 ies \"a.ies\" } light_source { x, 1 ies \"a.ies\" rotate 90*y } "
        "sphere { 0, 1 pigment { rgb 1 } finish { luminaire { ies \"a.ies\" } } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    const auto table = done.scene.lights.at(0).light.web;
    CHECK(table);
    CHECK(done.scene.lights.at(1).light.web == table);
    CHECK(done.texture().finish.lamp->web == table);
    CHECK(done.scene.lights.at(1).light.c0.z == Approx(-1));
}

TEST_CASE("what is wrong with a file is said where the scene names it", "[appearance]") {
    struct Row {
        std::string text, file, expected;
    };
    for (const Row& row : std::vector<Row>{
             {"light_source { 0, 1 ies \"b.ies\" }", even, "b.ies"},
             {"light_source { 0, 1 ies \"a.ies\" }", "no such thing", "`a.ies`: "},
             {"light_source { 0, 1 ies \"a.ies\" aim y c0 2*y }", even, "two directions"},
             {"light_source { 0, 1 ies \"a.ies\" spotlight }", even, "no `spotlight`"},
             {"light_source { 0, 1 ies \"a.ies\" parallel }", even, "parallel"},
             {"sphere { 0, 1 luminaire { ies \"b.ies\" } }", even, "b.ies"},
             {"sphere { 0, 1 luminaire { flux -1 } }", even, "flux"},
             {"sphere { 0, 1 luminaire { } }", even, "is empty"},
             {"sphere { 0, 1 luminaire { glow 3 } }", even, "glow"}}) {
        CAPTURE(row.text);
        const Script done = with_web(row.text, row.file);
        CHECK(done.text.find(row.expected) != std::string::npos);
    }
}

TEST_CASE("a tilt is followed for vertical lamps, and reported for others", "[appearance]") {
    const std::string lamp = "light_source { 0, 1 ies \"a.ies\" aim x c0 y }";
    const Script vertical = with_web(lamp, tilted("1"));
    CHECK(vertical.text.empty());
    REQUIRE(vertical.scene.lights.at(0).light.tilt);
    CHECK(tilt_factor(vertical.scene.lights.at(0).light) == Approx(0.8));
    const Script lying = with_web(lamp, tilted("2"));
    CHECK(lying.text.find("position of a horizontal lamp, which is not followed") !=
          std::string::npos);
    CHECK(tilt_factor(lying.scene.lights.at(0).light) == 1);
}

TEST_CASE("a scene with lamps in numbers is written as it is read", "[appearance]") {
    const std::string text =
        "light_source { <1, 2, 3>, rgb <1, 0.9, 0.8> ies \"a.ies\" flux 20 aim x c0 y } "
        "light_source { y, 1 intensity 4 } "
        "sphere { 0, 1 pigment { rgb 1 } finish { luminaire { flux 3 temperature 2700 } } } "
        "union { sphere { 0, 1 } box { 0, 1 } luminaire { flux 7 ies \"a.ies\" } }";
    const Script first = with_web(text);
    INFO(first.text);
    REQUIRE(first.text.empty());
    const std::string written = dump(first.scene);
    const Script again = run(written, {{"a.ies", even}});
    INFO(written << again.text);
    CHECK(again.text.empty());
    CHECK(dump(again.scene) == written);
}

}  // namespace candelabra
