// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/film_settings.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("settings of a film are changed by name, and go through a text", "[camera][film]") {
    FilmSettings film;
    CHECK(to_text(film).empty());
    const std::vector<FilmChange> changes = {
        {"exposure", "-1.5"},  {"white_balance", "3200"}, {"response", "agx"},
        {"vignette", "0.25"},  {"glare.veil", "0.3"},     {"pixel_filter", "mitchell"},
        {"glare.blades", "5"}, {"grain", "0.01"},         {"smooth_edges", "off"},
    };
    for (const FilmChange& each : changes) CHECK(change(film, each) == "");
    CHECK(film.on);
    CHECK(film.glares);
    CHECK(film.exposure == -1.5);
    CHECK(film.curve() == ResponseCurve::agx);
    CHECK(film.filter() == FilterShape::mitchell);
    CHECK_FALSE(film.smooths_edges());
    CHECK(film.exposure_factor() == Approx(std::exp2(-1.5)));
    const std::string text = to_text(film);
    CHECK(text ==
          "film=on exposure=-1.5 white_balance=3200 response=agx pixel_filter=mitchell "
          "smooth_edges=0 vignette=0.25 grain=0.01 glare=on glare.veil=0.3 glare.blades=5");
    const auto read = film_from_text(text);
    REQUIRE(read);
    CHECK(to_text(*read) == text);
}

TEST_CASE("an exposure is a number or automatic", "[camera][film]") {
    FilmSettings film;
    CHECK(change(film, {"exposure", "auto"}) == "");
    CHECK(film.auto_exposure);
    CHECK(change(film, {"exposure", "auto-1.5"}) == "");
    CHECK(film.auto_exposure);
    CHECK(film.exposure == -1.5);
    CHECK(to_text(*film_from_text(to_text(film))) == to_text(film));
    CHECK(change(film, {"exposure", "auto+2"}) == "");
    CHECK(film.exposure == 2);
    CHECK(change(film, {"exposure", "2"}) == "");
    CHECK_FALSE(film.auto_exposure);
}

TEST_CASE("wrong settings of a film change nothing", "[camera][film]") {
    const std::vector<FilmChange> wrong = {
        {"exposure", "bright"},   {"exposure", "autobahn"}, {"exposure", "1e9"},
        {"white_balance", "500"}, {"white_balance", "nan"}, {"response", "kodak"},
        {"pixel_filter", "disc"}, {"vignette", "2"},        {"glare.veil", "0.99"},
        {"glare.colour", "1"},    {"glare.blades", "5.5"},  {"lens", "1"},
        {"glare", "5"},           {"film", "maybe"},        {"grain_seed", "1e300"},
    };
    for (const FilmChange& each : wrong) {
        INFO(each.name << '=' << each.value);
        FilmSettings film;
        CHECK(change(film, each) != "");
        CHECK(to_text(film).empty());
    }
    for (const char* text : {"film", "film=on exposure", "film=on lens=5", "=", "film=on x=\xff"})
        CHECK_FALSE(film_from_text(text));
    FilmSettings film;
    CHECK(change(film, {"response", "kodak"}) ==
          "there is no response of a film `kodak`, but `linear`, `filmic` or `agx`");
    CHECK(change(film, {"vignette", "2"}) == "vignette must be a number from 0 to 1");
}

TEST_CASE("without a film nothing is done to samples", "[camera][film]") {
    FilmSettings film;
    film.exposure = 5;
    film.response = "agx";
    film.pixel_filter = "mitchell";
    CHECK(film.exposure_factor() == 1);
    CHECK(film.filter() == FilterShape::box);
    CHECK_FALSE(film.smooths_edges());
    film.on = true;
    CHECK(film.smooths_edges());
    film.response = "linear";
    CHECK_FALSE(film.smooths_edges());
    CHECK(change(film, {"film", "off"}) == "");
    CHECK(to_text(film).empty());
}

TEST_CASE("names of curves and filters are in the order of their numbers", "[camera][film]") {
    FilmSettings film;
    film.on = true;
    for (std::size_t i = 0; i < response_names().size(); ++i) {
        film.response = response_names()[i];
        CHECK(film.curve() == static_cast<ResponseCurve>(i));
    }
    for (std::size_t i = 0; i < filter_names().size(); ++i) {
        film.pixel_filter = filter_names()[i];
        CHECK(film.filter() == static_cast<FilterShape>(i));
    }
    CHECK(response_names().size() == 3);
    CHECK(filter_names().size() == 4);
}

}  // namespace candelabra
