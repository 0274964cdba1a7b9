// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_plate.h"

#include "film/film.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Image filled(int width, int height, const Vec3& colour) {
    Image image(width, height);
    for (Vec3& pixel : image.pixels) pixel = colour;
    return image;
}

/// A plate with two lamps that together give nine tenths of the light.
Plate lit_plate() {
    Plate plate;
    plate.width = plate.height = 2;
    plate.light = filled(2, 2, Vec3(0.6));
    plate.lights = {filled(2, 2, Vec3(0.4)), filled(2, 2, Vec3(0.1))};
    return plate;
}

const PlateFrame& frame() {
    static const PlateFrame made{{}, {}, {"lamp", "candle"}, 1, 1};
    return made;
}

}  // namespace

TEST_CASE("lamps are dimmed and coloured without being rendered", "[app]") {
    const Plate plate = lit_plate();
    Look look;
    CHECK_FALSE(look.relights());
    CHECK(relit(plate, frame().names, look).at(1, 1) == Vec3(0.6));
    look.lamps["lamp"] = {0, Vec3(1)};
    CHECK(look.relights());
    CHECK(relit(plate, frame().names, look).at(1, 1).y == Approx(0.2));
    look.lamps["candle"] = {2, Vec3(1, 0.5, 0)};
    const Vec3 shown = relit(plate, frame().names, look).at(0, 1);
    CHECK(shown.x == Approx(0.3));
    CHECK(shown.y == Approx(0.2));
    CHECK(shown.z == Approx(0.1));
    look.lamps["nobody"] = {9, Vec3(1)};
    CHECK(relit(plate, frame().names, look).at(0, 1) == shown);
}

TEST_CASE("pixels without samples show the coarse picture", "[app]") {
    Film film(4, 4, 3);
    film.at(1, 1).add(Vec3(0.5));
    film.extra(film.index(1, 1))[0].add(0.25);
    Aovs aovs;
    aovs.lights = true;
    Plate coarse;
    coarse.light = filled(2, 2, Vec3(0.1));
    coarse.light.at(1, 1) = Vec3(0.9);
    coarse.lights = {filled(2, 2, Vec3(0.05))};
    const Plate plate = plate_of(film, aovs, {}, true, &coarse);
    CHECK(plate.light.at(1, 1).x == Approx(0.5));
    CHECK(plate.light.at(0, 0).x == Approx(0.1));
    CHECK(plate.light.at(3, 3).x == Approx(0.9));
    CHECK(plate.light.at(2, 2).x > 0.1);
    CHECK(plate.light.at(2, 2).x < 0.9);
    CHECK(plate.lights.at(0).at(1, 1).x == Approx(0.25));
    CHECK(plate.lights.at(0).at(3, 0).x == Approx(0.05));
    CHECK(plate_of(film, aovs, {}, false, &coarse).lights.empty());
    CHECK(plate_of(film, aovs, {}, true).light.at(0, 0) == Vec3(0));
}

TEST_CASE("a plate is made smaller by means of its pixels", "[app]") {
    Plate plate = lit_plate();
    plate.light = Image(5, 3);
    plate.light.at(0, 0) = Vec3(1);
    plate.light.at(4, 2) = Vec3(0.5);
    const Plate small = reduced(plate, 2);
    CHECK(small.light.width == 3);
    CHECK(small.light.height == 2);
    CHECK(small.light.at(0, 0).x == Approx(0.25));
    CHECK(small.light.at(2, 1).x == Approx(0.5));
    CHECK(small.lights.at(0).at(0, 0).x == Approx(0.4));
    CHECK(small.width == 2);  // of the whole picture
}

TEST_CASE("the page changes the film setting by setting", "[app]") {
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

TEST_CASE("a print has the bytes that a file of it would have", "[app]") {
    Image image(256, 2);
    for (int x = 0; x < 256; ++x) {
        image.at(x, 0) = Vec3(x / 255.0, x / 2550.0, 1.5 * x / 255.0);
        image.at(x, 1) = Vec3(-1, std::nan(""), 1e30);
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

TEST_CASE("exposure doubles the light of a print", "[app]") {
    Look look;
    look.film = {{"exposure", "1"}};
    const Print print = print_of(lit_plate(), frame(), look);
    CHECK(print.image.at(0, 0).x == 1);  // clipped
    look.film = {{"exposure", "-1"}};
    CHECK(print_of(lit_plate(), frame(), look).image.at(0, 0).x == Approx(0.3));
    Plate layer = lit_plate();
    layer.view = filled(2, 2, Vec3(0.7));
    CHECK(print_of(layer, frame(), look).image.at(0, 0) == Vec3(0.7));
}

TEST_CASE("the light of the preview is saved with the light of each lamp", "[app]") {
    Look look;
    look.lamps["lamp"] = {2, Vec3(1)};
    Diagnostics diagnostics;
    const auto bytes = exr_of(lit_plate(), frame(), look, diagnostics);
    REQUIRE(bytes);
    for (const char* name : {"light.lamp.R", "light.candle.B"})
        CHECK(bytes->find(name) != std::string::npos);
    CHECK_FALSE(diagnostics.failed());
}

}  // namespace candelabra
