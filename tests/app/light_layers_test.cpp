// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/light_layers.h"

#include "picture/layers.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <filesystem>

TEST_CASE("layers show the shadow rays and the variance of each pixel", "[app]") {
    Film film(2, 1);
    film.at(0, 0).add(Vec3(0.25));
    film.at(0, 0).add(Vec3(0.81));
    film.at(0, 0).shadow_rays = 7;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "candelabra_light_layers.exr";
    Diagnostics diagnostics;
    REQUIRE(write_light_layers(film, file.string(), diagnostics));
    const auto read = read_layers(file.string(), {}, diagnostics);
    std::filesystem::remove(file);
    REQUIRE(read);
    const auto value = [&](const std::string& name, std::size_t pixel) {
        const auto plane = std::ranges::find(read->planes, name, &Plane::name);
        REQUIRE(plane != read->planes.end());
        return std::bit_cast<float>(plane->bits[pixel]);
    };
    CHECK(value("R", 0) == Approx(0.53f));
    CHECK(value("shadow_rays", 0) == 7);
    CHECK(value("variance", 0) == Approx(0.04).epsilon(1e-3));
    CHECK(value("variance", 1) == 0);
}
