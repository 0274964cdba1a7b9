// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <utility>
#include <vector>

namespace candelabra {

TEST_CASE("a film averages its samples", "[render]") {
    Film film(2, 1);
    film.at(1, 0).add(Rgb(1, 2, 3));
    film.at(1, 0).add(Rgb(3, 2, 1));
    const Image image = film.image();
    CHECK(image.at(0, 0) == Rgb(0));
    CHECK(image.at(1, 0) == Rgb(2));
}

TEST_CASE("the deviation is that of displayed values", "[render]") {
    PixelSum pixel;
    pixel.add(Rgb(0));
    pixel.add(Rgb(100));  // clipped to 1
    CHECK(pixel.deviation() == Approx(3 * std::sqrt(0.5)));
    PixelSum even;
    for (int i = 0; i < 5; ++i) even.add(Rgb(0.3));
    CHECK(even.deviation() == Approx(0).margin(1e-7));
}

TEST_CASE("samples that are subtracted count below zero", "[render]") {
    PixelSum pixel;
    pixel.add(Rgb(1));
    pixel.add(Rgb(1));
    pixel.add(Rgb(0.25), true);
    CHECK(pixel.samples == 3);
    CHECK(pixel.weight() == 1);
    CHECK(pixel.mean() == Rgb(1.75));
    PixelSum other;
    other.add(Rgb(1));
    other.add(pixel);
    CHECK(other.negative == 1);
    CHECK(other.mean() == Rgb(1.375));
    PixelSum alone;
    alone.add(Rgb(1), true);
    CHECK(alone.mean() == Rgb(0));
}

TEST_CASE("noise is that of light as it is exposed", "[render]") {
    PixelSum dark, exposed;
    for (const double light : {0.0, 0.01}) {
        dark.add(Rgb(light));
        exposed.add(Rgb(light), false, 100);
    }
    CHECK(exposed.deviation() == Approx(10 * dark.deviation()));
    CHECK(exposed.mean() == dark.mean());
}

TEST_CASE("exact sums do not depend on the order of what is added", "[render]") {
    const std::vector<double> values = {1e12,  0.1,     -3e-7,  1e300, 0.3,
                                        -1e12, 2.0 / 3, -1e300, 5e-16};
    ExactSum forwards, backwards, halves[2];
    for (std::size_t i = 0; i < values.size(); ++i) {
        forwards.add(values[i]);
        backwards.add(values[values.size() - 1 - i]);
        halves[i % 2].add(values[i]);
    }
    halves[1].add(halves[0]);
    CHECK(forwards == backwards);
    CHECK(forwards == halves[1]);
    CHECK(forwards.value() == Approx(1.0666663666666672));
    ExactSum from_words;
    for (int i = 0; i < 4; ++i) from_words.set_word(i, forwards.word(i));
    CHECK(from_words == forwards);
    ExactSum strange;
    strange.add(std::nan(""));
    CHECK(strange.value() == 0);
    forwards.subtract(backwards);
    CHECK(forwards.value() == 0);
    strange.add(-HUGE_VAL);
    CHECK(strange.value() == -ExactSum::greatest);
}

TEST_CASE("the variance of the mean is that of the worst channel", "[render]") {
    PixelSum pixel;
    pixel.add(Rgb(0, 0, 1));
    pixel.add(Rgb(1, 0, 0.25));
    CHECK(pixel.variance_of_mean() == Approx(0.25));
}

TEST_CASE("a film in a file has the sums of one in memory") {
    const Folder folder;
    const int width = 700, height = 500;
    auto pages = ZeroedPages::in_file(folder.path(), Film::bytes_of(width, height, 2));
    REQUIRE(pages);
    Film memory(width, height, 2), file(width, height, 2, std::move(*pages));
    for (Film* film : {&memory, &file})
        film->each([&](std::size_t i) {
            film->pixels()[i].add(Rgb(static_cast<double>(i % 7)));
            film->extra(i)[1].add(static_cast<double>(i));
        });
    CHECK(memory == file);
    const Film copy = file;
    file.extra(0)[0].add(1);
    CHECK_FALSE(memory == file);
    CHECK(memory == copy);
    CHECK(file.image().pixels == memory.image().pixels);
}

TEST_CASE("walks over a film keep to its rows") {
    Film film(3, 9);
    film.keep_to_rows(-1, 2);
    std::vector<std::size_t> numbers;
    film.each([&](std::size_t i) { numbers.push_back(i); });
    CHECK(numbers == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
    film.keep_to_rows(8, 12);
    numbers.clear();
    const Film copy = film;
    copy.each([&](std::size_t i) { numbers.push_back(i); });
    CHECK(numbers == std::vector<std::size_t>{24, 25, 26});
    CHECK(film.image().pixels.size() == 27);
}

}  // namespace candelabra
