// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/noise_rule.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

void fill(PixelSum& pixel, double a, double b) {
    for (int i = 0; i < 4; ++i) pixel.add(Rgb(i % 2 ? a : b));
}

}  // namespace

TEST_CASE("a pixel gets more samples when its neighbours differ, whatever its own are",
          "[render]") {
    Film film(5, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x) fill(film.at(x, y), 0.2, 0.2);
    film.at(2, 2) = PixelSum();
    fill(film.at(2, 2), 0, 1);
    const NoiseBound enough{0.05, 64};
    CHECK(samples_to_add(film, 1, 1, enough) == 60);
    CHECK(samples_to_add(film, 3, 2, enough) == 60);
    CHECK(samples_to_add(film, 2, 2, enough) == 0);
    CHECK(samples_to_add(film, 0, 0, enough) == 0);
    CHECK(samples_to_add(film, 4, 4, enough) == 0);
}

}  // namespace candelabra
