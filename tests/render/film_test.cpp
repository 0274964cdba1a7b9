// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film.h"

#include <catch2/catch.hpp>

TEST_CASE("a film averages its samples", "[render]") {
    Film film(2, 1);
    film.at(1, 0).add(Vec3(1, 2, 3));
    film.at(1, 0).add(Vec3(3, 2, 1));
    const Image image = film.image();
    CHECK(image.at(0, 0) == Vec3(0));
    CHECK(image.at(1, 0) == Vec3(2));
}

TEST_CASE("the deviation is that of displayed values", "[render]") {
    PixelSum pixel;
    pixel.add(Vec3(0));
    pixel.add(Vec3(100));  // shows as 1
    CHECK(pixel.deviation() == Approx(3 * std::sqrt(0.5)));
    PixelSum even;
    for (int i = 0; i < 5; ++i) even.add(Vec3(0.3));
    CHECK(even.deviation() == Approx(0).margin(1e-7));
}
