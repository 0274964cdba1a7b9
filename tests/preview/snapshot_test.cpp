// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/snapshot.h"

#include "film/film.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Image filled(int width, int height, const Rgb& colour) {
    Image image(width, height);
    for (Rgb& pixel : image.pixels) pixel = colour;
    return image;
}

/// A snapshot with two lamps that together give nine tenths of the light.
LightSnapshot lit_snapshot() {
    LightSnapshot snapshot;
    snapshot.width = snapshot.height = 2;
    snapshot.light = filled(2, 2, Rgb(0.6));
    snapshot.lights = {filled(2, 2, Rgb(0.4)), filled(2, 2, Rgb(0.1))};
    return snapshot;
}

const SnapshotContext& context() {
    static const SnapshotContext made{{}, {}, {"lamp", "candle"}, 1, 1};
    return made;
}

}  // namespace

TEST_CASE("lamps are dimmed and coloured without being rendered", "[preview]") {
    const LightSnapshot snapshot = lit_snapshot();
    Look look;
    CHECK_FALSE(look.relights());
    CHECK(relit(snapshot, context().names, look).at(1, 1) == Rgb(0.6));
    look.lamps["lamp"] = {0, Rgb(1)};
    CHECK(look.relights());
    CHECK(relit(snapshot, context().names, look).at(1, 1).g == Approx(0.2));
    look.lamps["candle"] = {2, Rgb(1, 0.5, 0)};
    const Rgb shown = relit(snapshot, context().names, look).at(0, 1);
    CHECK(shown.r == Approx(0.3));
    CHECK(shown.g == Approx(0.2));
    CHECK(shown.b == Approx(0.1));
    look.lamps["nobody"] = {9, Rgb(1)};
    CHECK(relit(snapshot, context().names, look).at(0, 1) == shown);
}

TEST_CASE("pixels without samples show the coarse picture", "[preview]") {
    Film film(4, 4, 3);
    film.at(1, 1).add(Rgb(0.5));
    film.extra(film.index(1, 1))[0].add(0.25);
    Aovs aovs;
    aovs.lights = true;
    LightSnapshot coarse;
    coarse.light = filled(2, 2, Rgb(0.1));
    coarse.light.at(1, 1) = Rgb(0.9);
    coarse.lights = {filled(2, 2, Rgb(0.05))};
    const LightSnapshot snapshot = snapshot_of(film, aovs, {}, true, &coarse);
    CHECK(snapshot.light.at(1, 1).r == Approx(0.5));
    CHECK(snapshot.light.at(0, 0).r == Approx(0.1));
    CHECK(snapshot.light.at(3, 3).r == Approx(0.9));
    CHECK(snapshot.light.at(2, 2).r > 0.1);
    CHECK(snapshot.light.at(2, 2).r < 0.9);
    CHECK(snapshot.lights.at(0).at(1, 1).r == Approx(0.25));
    CHECK(snapshot.lights.at(0).at(3, 0).r == Approx(0.05));
    CHECK(snapshot_of(film, aovs, {}, false, &coarse).lights.empty());
    CHECK(snapshot_of(film, aovs, {}, true).light.at(0, 0) == Rgb(0));
}

TEST_CASE("a snapshot is made smaller by means of its pixels", "[preview]") {
    LightSnapshot snapshot = lit_snapshot();
    snapshot.light = Image(5, 3);
    snapshot.light.at(0, 0) = Rgb(1);
    snapshot.light.at(4, 2) = Rgb(0.5);
    const LightSnapshot small = reduced(snapshot, 2);
    CHECK(small.light.width == 3);
    CHECK(small.light.height == 2);
    CHECK(small.light.at(0, 0).r == Approx(0.25));
    CHECK(small.light.at(2, 1).r == Approx(0.5));
    CHECK(small.lights.at(0).at(0, 0).r == Approx(0.4));
    CHECK(small.width == 2);  // of the whole picture
}

TEST_CASE("the page changes the film setting by setting", "[preview]") {
    FilmSettings film;
    CHECK(change_look(film, {"exposure", "1.5"}).empty());
    CHECK(film.on);
    CHECK(change_look(film, {"auto", "on"}).empty());
    CHECK(change_look(film, {"exposure", "-1"}).empty());
    CHECK(film.auto_exposure);
    CHECK(film.exposure == -1);
    CHECK_FALSE(change_look(film, {"auto", "perhaps"}).empty());
    CHECK_FALSE(change_look(film, {"exposure", "many"}).empty());
    Look look;
    look.film = {{"response", "agx"}, {"vignette", "7"}, {"glare.veil", "0.1"}};
    const FilmSettings made = film_with({}, look);
    CHECK(made.response == "agx");
    CHECK(made.vignette == 0);
    CHECK(made.glare.veil == 0.1);
}

TEST_CASE("a display image has the bytes that a file of it would have", "[preview]") {
    Image image(256, 2);
    for (int x = 0; x < 256; ++x) {
        image.at(x, 0) = Rgb(x / 255.0, x / 2550.0, 1.5 * x / 255.0);
        image.at(x, 1) = Rgb(-1, std::nan(""), 1e30);
    }
    for (const double gamma : {1.0, 2.2}) {
        PictureFormat format;
        format.gamma = gamma;
        const std::string bytes = screen_bytes({image, format}, 1);
        REQUIRE(bytes.size() == 4 * 512);
        for (std::size_t i = 0; i < 512; ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                INFO(i << " " << c);
                CHECK(static_cast<unsigned char>(bytes[4 * i + c]) ==
                      quantised(image.pixels[i][static_cast<int>(c)], 255, format));
            }
            CHECK(bytes[4 * i + 3] == '\xff');
        }
    }
}

TEST_CASE("exposure doubles the light of a display image", "[preview]") {
    Look look;
    look.film = {{"exposure", "1"}};
    const DisplayImage shown = display_image(lit_snapshot(), context(), look);
    CHECK(shown.image.at(0, 0).r == 1);  // clipped
    look.film = {{"exposure", "-1"}};
    CHECK(display_image(lit_snapshot(), context(), look).image.at(0, 0).r == Approx(0.3));
    LightSnapshot layer = lit_snapshot();
    layer.view = filled(2, 2, Rgb(0.7));
    CHECK(display_image(layer, context(), look).image.at(0, 0) == Rgb(0.7));
}

TEST_CASE("the light of the preview is saved with the light of each lamp", "[preview]") {
    Look look;
    look.lamps["lamp"] = {2, Rgb(1)};
    Diagnostics diagnostics;
    const auto bytes = exr_of(lit_snapshot(), context(), look, diagnostics);
    REQUIRE(bytes);
    for (const char* name : {"light.lamp.R", "light.candle.B"})
        CHECK(bytes->find(name) != std::string::npos);
    CHECK_FALSE(diagnostics.failed());
}

}  // namespace candelabra
