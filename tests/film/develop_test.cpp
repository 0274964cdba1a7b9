// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/develop.h"

#include "film/response.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

FilmSettings film_with(std::initializer_list<FilmChange> changes) {
    FilmSettings film;
    film.on = true;
    for (const FilmChange& each : changes) REQUIRE(change(film, each) == "");
    return film;
}

Negative even(const Rgb& light, int width = 12, int height = 8) {
    Negative negative{Image(width, height), {}, {}};
    for (Rgb& pixel : negative.light.pixels) pixel = light;
    return negative;
}

}  // namespace

TEST_CASE("a film that changes nothing clips", "[film][develop]") {
    const Image made = develop(even({0.25, 2, -1}), film_with({}), 1);
    CHECK(made.at(5, 5) == Rgb(0.25, 1, 0));
    CHECK(develop(Negative(), film_with({}), 1).pixels.empty());
}

TEST_CASE("exposure, white balance and response come one after the other", "[film][develop]") {
    const Image made =
        develop(even({0.25, 0.5, 0.125}), film_with({{"exposure", "1"}, {"response", "agx"}}), 1);
    CHECK(made.at(2, 2) == respond(ResponseCurve::agx, {0.5, 1, 0.25}));
    const Image grey = develop(even(Rgb(0.01)), film_with({{"exposure", "auto"}}), 1);
    const double lifted = std::log2(grey.at(0, 0).r / 0.01);
    CHECK(lifted == Approx(4 * (1 - std::exp(-std::log2(18) / 4))).margin(1e-3));
    CHECK(exposure_of(even(Rgb(0.18)), film_with({{"exposure", "auto-1"}})) ==
          Approx(-1).margin(1e-6));
    const Image warm = develop(even({0.5, 0.3, 0.1}), film_with({{"white_balance", "2700"}}), 1);
    CHECK(warm.at(0, 0).b > 0.2);
    CHECK(warm.at(0, 0).r < 0.4);
}

TEST_CASE("contrast turns around a middle grey, saturation around the grey of a colour",
          "[film][develop]") {
    const auto shown = [](const Rgb& light, const char* setting, const char* value) {
        return develop(even(light), film_with({{setting, value}}), 1).at(3, 3);
    };
    CHECK(shown(Rgb(0.18), "contrast", "1.5").r == Approx(0.18).epsilon(1e-6));
    CHECK(shown(Rgb(0.36), "contrast", "1.5").r == Approx(0.18 * std::pow(2, 1.5)).epsilon(1e-6));
    CHECK(shown(Rgb(0.09), "contrast", "0.5").r == Approx(0.18 * std::sqrt(0.5)).epsilon(1e-6));
    CHECK(shown(Rgb(-1, 0, 0.3), "contrast", "2").r == 0);
    const Rgb colour(0.5, 0.25, 0.125);
    const double grey = 0.2126 * 0.5 + 0.7152 * 0.25 + 0.0722 * 0.125;
    CHECK(shown(colour, "saturation", "0").g == Approx(grey).epsilon(1e-6));
    CHECK(shown(colour, "saturation", "0").b == Approx(grey).epsilon(1e-6));
    const Rgb lively = shown(colour, "saturation", "1.5");
    for (int c = 0; c < 3; ++c) CHECK(lively[c] == Approx(grey + 1.5 * (colour[c] - grey)));
    CHECK(shown({1, 0, 0}, "saturation", "4") == Rgb(1, 0, 0));
    CHECK(contrasted(colour, 1) == colour);
    CHECK(saturated(colour, 1) == colour);
}

TEST_CASE("the key is the luminance that an automatic exposure gives", "[film][develop]") {
    const Negative bright = even(Rgb(3));
    for (const double key : {0.045, 0.09, 0.18, 0.36}) {
        const FilmSettings film = film_with({{"exposure", "auto"}, {"key", std::to_string(key)}});
        CHECK(develop(bright, film, 1).at(1, 1).r == Approx(key).epsilon(1e-3));
    }
}

TEST_CASE("corners lose the share of a vignette", "[film][develop]") {
    const Image made = develop(even(Rgb(0.8), 401, 301), film_with({{"vignette", "0.5"}}), 2);
    CHECK(made.at(200, 150).r == Approx(0.8).epsilon(1e-4));
    CHECK(made.at(0, 0).r == Approx(0.4).epsilon(0.01));
    CHECK(made.at(0, 0).r == Approx(made.at(400, 300).r));
    CHECK(vignetted(1, 1) == Approx(0).margin(1e-12));
    CHECK(vignetted(0, 0.7) == 1);
}

TEST_CASE("grain keeps the mean, and is another one for each seed", "[film][develop]") {
    const auto shown = [](const char* seed) {
        return develop(even(Rgb(0.25), 200, 100),
                       film_with({{"grain", "0.05"}, {"grain_seed", seed}}), 1);
    };
    const Image made = shown("1");
    double sum = 0, squares = 0;
    for (const Rgb& pixel : made.pixels) {
        sum += pixel.r;
        squares += pixel.r * pixel.r;
    }
    const double count = static_cast<double>(made.pixels.size()), mean = sum / count;
    CHECK(mean == Approx(0.25).epsilon(0.01));
    CHECK(std::sqrt(squares / count - mean * mean) ==
          Approx(0.05 * std::sqrt(0.25 * 0.75)).epsilon(0.05));
    CHECK(made.pixels == shown("1").pixels);
    CHECK(made.pixels != shown("2").pixels);
    CHECK(develop(even(Rgb(0)), film_with({{"grain", "1"}}), 1).at(1, 1) == Rgb(0));
}

TEST_CASE("means of compressed samples are brought back", "[film][develop]") {
    for (const Rgb& light : {Rgb(0), Rgb(0.5, 0.2, 0), Rgb(1e6, 10, 1)}) {
        const Rgb back = expanded(compressed(light, 2), 2);
        for (int c = 0; c < 3; ++c) CHECK(back[c] == Approx(light[c]).epsilon(1e-6));
    }
    // A pixel half covered by a very bright lamp, and one covered by a tenth.
    const Rgb half = expanded(0.5 * compressed(Rgb(1e5), 4), 4);
    CHECK(half.r == Approx(0.25).epsilon(1e-3));
    const Rgb little = expanded(0.1 * compressed(Rgb(1e5), 4), 4);
    CHECK(little.r == Approx(0.25 / 9).epsilon(1e-3));
    CHECK(compressed(Rgb(INFINITY), 4) == Rgb(0.25));
    CHECK(compressed(Rgb(NAN, NAN, NAN), 4) == Rgb(0));
    CHECK(compressed(Rgb(-1), 4) == Rgb(0));
}

TEST_CASE("the smooth picture stays, and the exact one glares", "[film][develop]") {
    Negative negative = even(Rgb(0), 40, 30);
    negative.light.at(20, 15) = Rgb(1000);
    const FilmSettings film = film_with({{"glare.veil", "0.4"}});
    const Image exact = develop(negative, film, 1);
    negative.smooth = negative.light;
    CHECK(develop(negative, film, 1).pixels == exact.pixels);
    negative.smooth.at(20, 15) = Rgb(0.1);
    const Image smooth = develop(negative, film, 1);
    CHECK(smooth.at(25, 15).r == Approx(exact.at(25, 15).r).epsilon(1e-6));
    CHECK(smooth.at(20, 15).r < 1.0001);
    CHECK(exact.at(25, 15).r > 0);
}

TEST_CASE("what is half clear is developed as if it were opaque", "[film][develop]") {
    const FilmSettings film = film_with({{"response", "agx"}});
    Negative negative = even(Rgb(0.5));
    negative.alpha.assign(negative.light.pixels.size(), 0.5);
    const Rgb opaque = respond(ResponseCurve::agx, Rgb(1));
    CHECK(develop(negative, film, 1).at(3, 3).r == Approx(0.5 * opaque.r));
}

}  // namespace candelabra
