// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/assets.h"

#include "support/script.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

namespace candelabra {

TEST_CASE("a height field takes its heights from a function", "[objects]") {
    const Script done = run("#version 3.7; height_field { function 3, 2 { x/2 + y/4 } smooth }");
    REQUIRE(done.text.empty());
    const HeightField& field = *done.shape<Shared<HeightField>>();
    REQUIRE(field.grid);
    CHECK(field.smooth);
    CHECK(field.grid->width == 3);
    // The first row has z = 0, which is y = 1 in the picture.
    CHECK(field.grid->values == std::vector<std::uint16_t>{16383, 32767, 49151, 0, 16383, 32767});
}

TEST_CASE("what a shape lacks is told of", "[objects]") {
    CHECK(complaint("height_field { function { x } }") ==
          "error wrong-type: the function of a `height_field` needs the number of heights");
    CHECK(complaint("height_field { function 0, 5 { x } }") ==
          "error out-of-range: a picture made by a function has a width and a height from 1 to "
          "16384");
    CHECK(complaint("height_field { \"none.png\" }").ends_with(": there is no file `none.png`"));
    CHECK(
        complaint("text { ttf \"no font\" \"A\" 1, 0 }").ends_with(": there is no file `no font`"));
    CHECK(complaint("text { \"A\" 1, 0 }") ==
          "error degenerate: a `text` needs `ttf` or `internal`");
}

TEST_CASE("the ends of a lathe lie beside the axis from version 3.8 on", "[objects]") {
    const std::string lathe = "lathe { linear_spline 3, <-0.5, -1>, <0.5, 0>, <0.5, 1> }";
    const std::string text = "the first and the last radius of a `lathe` should not be below 0";
    CHECK(run("#version 3.7; " + lathe).text.starts_with("warning[no-effect]: " + text));
    CHECK(run("#version 3.8; " + lathe).text.starts_with("error: " + text));
    CHECK(run("#version 3.8; lathe { cubic_spline 4, <-0.5, -1>, <0.5, 0>, <0.5, 1>, <-1, 2> }")
              .text.empty());
}

TEST_CASE("a font is looked for and read once", "[objects]") {
    int readings = 0;
    SourceStore sources;
    Diagnostics diagnostics;
    const Loader loader([&](const std::string& path) -> std::optional<std::string> {
        if (path == "a.ttf") ++readings;
        return path == "a.ttf" ? std::optional<std::string>("no font") : std::nullopt;
    });
    const std::string script =
        "#version 3.7; #for (I, 1, 5) text { ttf \"a.ttf\" \"A\" 1, 0 } #end";
    evaluate(sources, loader, sources.add("main.pov", script), {}, diagnostics);
    CHECK(readings == 1);
    CHECK(diagnostics.all().size() == 1);
}

TEST_CASE("a font of the library stands in for one that is not installed", "[objects]") {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/stdlib/fonts/povlogo.ttf", std::ios::binary);
    const std::string font(std::istreambuf_iterator<char>(file), {});
    SourceStore sources;
    Diagnostics diagnostics;
    const Loader loader([&](const std::string& path) -> std::optional<std::string> {
        return path == "fonts/not_installed.ttf" ? std::optional(font) : std::nullopt;
    });
    const auto main =
        sources.add("main.pov", "#version 3.7; text { ttf \"not_installed\" \"P\" 1, 0 }");
    const Scene scene = evaluate(sources, loader, main, {}, diagnostics);
    CHECK(scene.objects.size() == 1);
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all().front().message ==
          "there is no font `not_installed`: `fonts/not_installed.ttf` stands in for it");
}

TEST_CASE("a text without letters is an object without a surface", "[objects]") {
    const Script done = run("#version 3.7; text { ttf \"a.ttf\" \"\" 1, 0 }");
    CHECK(done.text.empty());
    CHECK(done.scene.objects.empty());
}

TEST_CASE("values of an isosurface that cannot be meant are the usual ones", "[objects]") {
    const std::string start = "isosurface { function { x } ";
    CHECK(complaint(start + "accuracy 0 }") ==
          "warning no-effect: `accuracy` of `isosurface` is 0, which is not above 0: the usual "
          "0.001 counts");
    CHECK(complaint(start + "max_gradient -2 }") ==
          "warning no-effect: `max_gradient` of `isosurface` is -2, which is not above 0: the "
          "usual 1.1 counts");
    CHECK(complaint(start + "accuracy 0.1 max_gradient 2 }") == "nothing");
    const Script done = run("#version 3.7; " + start + "accuracy 0 }");
    CHECK(done.shape<Shared<Isosurface>>()->accuracy == Isosurface().accuracy);
}

}  // namespace candelabra
