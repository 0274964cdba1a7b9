// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/pictures.h"

#include "support/folder.h"
#include "support/script.h"
#include "support/scripts.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "surface/texture_map.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

Script with(const std::string& pigment) {
    return run("#version 3.7; sphere { 0, 1 pigment { " + pigment + " } }");
}

std::string picture_complaint(const std::string& braces) {
    return complaint("sphere { 0, 1 pigment { image_map { " + braces + " } } }");
}

}  // namespace

TEST_CASE("pictures of version 3.8 have its opacity and its gamma", "[appearance]") {
    const auto image = [](const std::string& version, const std::string& braces) {
        const std::map<std::string, std::string> files = {
            {"p.ppm", std::string("P6 1 1 255\n\x80\x80\x80", 14)}};
        const Script done = run(
            "#version " + version + "; sphere { 0, 1 pigment { image_map { " + braces + " } } }",
            files);
        INFO(done.text);
        REQUIRE(done.text.empty());
        return std::get<ImageMap>(done.texture().pigment.pattern->use.pattern);
    };
    const std::string clear =
        "function 2, 2 { pigment { rgbt <0.3, 1, 0, 0.5> } } transmit all 0.5";
    const Vec3 middle(0.5, 0.5, 0);
    CHECK(colour_at(image("3.7", clear), middle)->transmit == Approx(1).margin(1e-4));
    CHECK(colour_at(image("3.8", clear), middle)->transmit == Approx(0.75).margin(1e-4));
    const std::string opaque = "function 2, 2 { x } transmit all 0.5";
    CHECK(colour_at(image("3.8", opaque), middle)->transmit == 0.5);
    const double stored = 128.0 / 255;
    const auto light = [&](const std::string& version, const std::string& gamma) {
        return colour_at(image(version, "ppm \"p.ppm\" " + gamma), middle)->rgb.r;
    };
    CHECK(light("3.7", "") == Approx(stored).margin(1e-6));
    const double video = std::pow((stored + 0.099) / 1.099, 1 / 0.45);
    CHECK(light("3.8", "") == Approx(video).margin(1e-6));
    CHECK(light("3.7", "gamma bt709") == Approx(video).margin(1e-6));
    CHECK(light("3.8", "gamma 1") == Approx(stored).margin(1e-6));
    CHECK(light("3.7", "gamma bt2020") ==
          Approx(std::pow((stored + 0.0993) / 1.0993, 1 / 0.45)).margin(1e-6));
}

TEST_CASE("a picture may be a function of x and y, down from the top", "[appearance]") {
    const Script done = with("image_map { function 3, 2 { x/2 + y/4 } map_type 1 once }");
    REQUIRE(done.text.empty());
    const auto& image = std::get<ImageMap>(done.texture().pigment.pattern->use.pattern);
    REQUIRE(image.texels);
    CHECK(image.map_type == 1);
    CHECK(image.once);
    CHECK(image.texels->width == 3);
    CHECK(image.texels->channels == 1);
    CHECK(image.texels->values[1] == Approx(0.25).margin(2e-5));
    CHECK(image.texels->values[3] == Approx(0.25).margin(2e-5));
    // As in POV-Ray, values are quantised and wrap around outside of 0 to 1.
    const Script far = with("image_map { function 2, 1 { x*1.7 - 0.5 } }");
    const auto& beyond = std::get<ImageMap>(far.texture().pigment.pattern->use.pattern);
    CHECK(beyond.texels->values[0] == Approx(32769 / 65535.0));
    CHECK(beyond.texels->values[1] == Approx(13106 / 65535.0));
    const Script colours =
        with("image_map { function 2, 2 { pigment { rgbt <0.3, 1, 0, 0.5> } } }");
    REQUIRE(colours.text.empty());
    const Texels& texels =
        *std::get<ImageMap>(colours.texture().pigment.pattern->use.pattern).texels;
    CHECK(texels.channels == 3);
    CHECK(texels.transparent());
}

TEST_CASE("filter and transmit name all colours or one", "[appearance]") {
    const Script done = with(
        "image_map { function 2, 2 { x } filter all 0.5 transmit 3, 0.25 filter 0, .1 "
        "interpolate 2 }");
    REQUIRE(done.text.empty());
    const auto& image = std::get<ImageMap>(done.texture().pigment.pattern->use.pattern);
    REQUIRE(image.adjustments.size() == 3);
    CHECK(image.adjustments[0].number == -1);
    CHECK_FALSE(image.adjustments[1].filter);
    CHECK(image.adjustments[1].number == 3);
    CHECK(image.adjustments[1].amount == 0.25);
    CHECK(image.adjustments[2].filter);
    CHECK(image.adjustments[2].number == 0);
    CHECK(image.interpolate == 2);
}

TEST_CASE("what is wrong with a picture is told of", "[appearance]") {
    CHECK(picture_complaint("function 2, 2 { x } transmit -3, 0.5") ==
          "error out-of-range: `transmit` of a picture needs the number of a colour, counted from "
          "0, but here is -3");
    CHECK(picture_complaint("function 2, 2 { x } filter 1e300, 0.5") ==
          "error out-of-range: `filter` of a picture needs the number of a colour, counted from 0, "
          "but here is 1e+300");
    CHECK(picture_complaint("png \"x.png\"") ==
          "error include-not-found: there is no file `x.png`");
    CHECK(picture_complaint("gamma srgb") == "error missing: `image_map` needs a picture");
    CHECK(picture_complaint("function { x }") ==
          "error wrong-type: the function of a picture needs the number of pixels");
    CHECK(picture_complaint("function 2, 2 { x } map_type 3") ==
          "error out-of-range: there is no `map_type` 3");
    CHECK(picture_complaint("function 2, 2 { x } interpolate 1") ==
          "error out-of-range: there is no `interpolate` 1");
    CHECK(picture_complaint("function 2, 2 { x } filter all") ==
          "error missing: `filter` and `transmit` of a picture need a number");
    CHECK(complaint("sphere { 0, 1 texture { material_map { function 2, 2 { x } } } }") ==
          "error missing: `material_map` needs textures");
    CHECK(complaint("sphere { 0, 1 pigment { rgb 1 } normal { image_map { function 2, 2 { x } } } "
                    "}") == "error misplaced: `image_map` is for pigments only");
}

TEST_CASE("a bump_map has its height in the braces or behind them", "[appearance]") {
    const auto size = [](const std::string& normal) {
        const Script done =
            run("#version 3.7; sphere { 0, 1 pigment { rgb 1 } normal { " + normal + " } }");
        REQUIRE(done.text.empty());
        return done.texture().normal.pattern->settings.bump_size;
    };
    CHECK(size("bump_map { function 2, 2 { x } bump_size 3 }") == 3);
    CHECK(size("bump_map { function 2, 2 { x } } bump_size 4") == 4);
    CHECK(size("bump_map { function 2, 2 { x } bump_size 3 } bump_size 4") == 4);
}

TEST_CASE("a material_map has textures by number", "[appearance]") {
    const Script done = run(R"(#version 3.7; sphere { 0, 1 texture { material_map {
        function 2, 2 { x } texture { pigment { rgb 1 } } texture { pigment { rgb x } } } } })");
    REQUIRE(done.text.empty());
    REQUIRE(done.texture().choice);
    CHECK(done.texture().choice->map.size() == 2);
    CHECK(std::get<MaterialMap>(done.texture().choice->use.pattern).textures == 2);
}

TEST_CASE("uv_mapping may stand in textures and in what they consist of", "[appearance]") {
    const Script done = run(R"(#version 3.7;
        sphere { 0, 1 pigment { uv_mapping checker scale 0.1 } scale 2 }
        sphere { 0, 1 texture { uv_mapping pigment { checker } normal { bumps } } }
        box { 0, 1 uv_mapping pigment { checker } rotate 45*y })");
    REQUIRE(done.text.empty());
    const Pigment& own = done.texture().pigment;
    CHECK(own.uv);
    CHECK(own.transform.point(Vec3(1, 0, 0)).x == Approx(0.1));
    CHECK(done.texture(1).pigment.uv);
    CHECK(done.texture(1).normal.uv);
    CHECK(done.object(2).uv_mapping);
    CHECK(done.texture(2).pigment.transform == Transform());
}

TEST_CASE("what the loader has read is what becomes a picture: no file is opened again",
          "[appearance]") {
    const fs::path pictures = CANDELABRA_SOURCE_DIR "/tests/conformance/pictures";
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(pictures)) {
        const std::string ending = entry.path().extension().string();
        const auto known = picture_endings("");
        if (std::ranges::find(known, ending) == known.end()) continue;
        ++count;
        CAPTURE(entry.path().string());
        // No file on the disk has this name.
        const std::string name = "nowhere" + ending;
        const std::map files = {std::pair(name, disk_reader()(entry.path().string()).value())};
        const std::string quoted = '"' + name + '"';
        const Script image =
            run("#version 3.7; sphere { 0, 1 pigment { image_map { " + quoted + " } } }", files);
        CHECK(image.text == "");
        const Script heights = run("#version 3.7; height_field { " + quoted + " }", files);
        const bool small = heights.text.find("fewer than 2 by 2 heights") != std::string::npos;
        CHECK((small || heights.text.empty()));
    }
    CHECK(count > 4);
}

TEST_CASE("the ending of a picture's name may be left out", "[appearance]") {
    CHECK(picture_endings("png")[1] == ".PNG");
    CHECK(picture_endings("")[0] == ".png");
    CHECK(picture_endings("jpeg").size() == 4);
    CHECK(picture_endings("sys").empty());
    const Folder folder;
    fs::copy_file(CANDELABRA_SOURCE_DIR "/tests/conformance/pictures/p.tga", folder / "a.TGA");
    fs::copy_file(CANDELABRA_SOURCE_DIR "/tests/conformance/pictures/p.ppm", folder / "a.ppm");
    fs::copy_file(CANDELABRA_SOURCE_DIR "/tests/conformance/pictures/g1.png", folder / "b.png");
    const auto said = [&](const std::string& picture) {
        const std::size_t name = picture.find('"') + 1;
        const std::string text = std::string(picture).insert(name, folder.path().string() + "/");
        const std::string script = text.starts_with("height_field")
                                       ? text
                                       : "sphere { 0, 1 pigment { image_map { " + text + " } } }";
        return evaluated("#version 3.7; " + script).diagnostics;
    };
    for (const std::string good :
         {"tga \"a\"", "ppm \"a\"", "png \"b\"", "\"b\"", "\"b.png\"", "height_field { tga \"a\" }",
          "height_field { png \"b\" }", "height_field { \"b\" smooth }"}) {
        INFO(good);
        CHECK(said(good).empty());
    }
    for (const std::string bad :
         {"png \"a\"", "\"a\"", "jpeg \"b\"", "sys \"b\"", "tga \"b.png.tga\"", "png \"b.\"",
          "height_field { png \"a\" }", "height_field { sys \"b\" }"}) {
        INFO(bad);
        CHECK(said(bad).find("there is no file") != std::string::npos);
    }
}

}  // namespace candelabra
