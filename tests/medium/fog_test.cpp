// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/fog.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

namespace {

double seen(const Fog& fog, const Ray& ray, double distance) {
    return veil_of(std::span(&fog, 1), ray, distance, NoiseGenerator::full_range).added.r;
}

}  // namespace

TEST_CASE("fog takes its colour by the distance", "[medium]") {
    Fog fog;
    fog.colour.rgb = Rgb(1);
    fog.distance = 4;
    const Ray ray{Vec3(0), Vec3(0, 0, 1)};
    CHECK(seen(fog, ray, 4) == Approx(1 - std::exp(-1)));
    CHECK(seen(fog, ray, std::numeric_limits<double>::infinity()) == Approx(1));
    fog.colour.transmit = 0.3;
    CHECK(seen(fog, ray, std::numeric_limits<double>::infinity()) == Approx(0.7));
    fog.distance = 0;
    CHECK(seen(fog, ray, 4) == 0);
}

TEST_CASE("everything in a ground fog without a direction is black, as in POV-Ray", "[medium]") {
    Fog fog;
    fog.colour.rgb = Rgb(1);
    fog.distance = 4;
    fog.up = Vec3(0);
    const Ray ray{Vec3(0, 5, 0), Vec3(0, 0, 1)};
    CHECK(seen(fog, ray, 4) == Approx(1 - std::exp(-1)));
    fog.fog_type = 2;
    for (const double distance : {0.1, 4.0, std::numeric_limits<double>::infinity()}) {
        const auto veil =
            veil_of(std::span(&fog, 1), ray, distance, NoiseGenerator::full_range);
        CHECK(veil.through(Rgb(1)) == Rgb(0));
        CHECK(left_by(std::span(&fog, 1), ray, distance, NoiseGenerator::full_range) == Rgb(0));
    }
}

TEST_CASE("ground fog thins out upwards", "[medium]") {
    Fog fog;
    fog.colour.rgb = Rgb(1);
    fog.distance = 4;
    fog.fog_type = 2;
    fog.fog_offset = 1;
    fog.fog_alt = 2;
    const Vec3 along(0, 0, 1);
    CHECK(seen(fog, {Vec3(0, 1, 0), along}, 4) == Approx(1 - std::exp(-1)));
    CHECK(seen(fog, {Vec3(0, 3, 0), along}, 4) == Approx(1 - std::exp(-0.5)));
    // From the ground up: one unit of full density, then an arctangent.
    const double column = 1 + 2 * std::atan(2.0);
    CHECK(seen(fog, {Vec3(0), Vec3(0, 1, 0)}, 5) == Approx(1 - std::exp(-column / 4)));
}

}  // namespace candelabra
