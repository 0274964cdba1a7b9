// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/media.h"

#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Scattering of_type(int type, double eccentricity = 0) {
    Scattering s;
    s.type = type;
    s.colour = Rgb(1);
    s.eccentricity = eccentricity;
    return s;
}

}  // namespace

TEST_CASE("phase functions have POV-Ray's constants", "[medium]") {
    CHECK(phase(of_type(1), 0.3) == 1);
    CHECK(phase(of_type(0), 0.3) == 1);
    CHECK(phase(of_type(2), 1) == Approx(5.76655));
    CHECK(phase(of_type(3), 1) == Approx(25.281465));
    CHECK(phase(of_type(4), -1) == Approx(1.598744));
    CHECK(phase(of_type(5, 0.5), 1) == Approx(6));
    CHECK(phase(of_type(5), -0.2) == 1);
    CHECK(phase(of_type(5, 1), 1) == 0);
}

TEST_CASE("means of phase functions over the sphere", "[medium]") {
    const auto mean = [](const Scattering& s) {
        constexpr int steps = 20000;
        double sum = 0;
        for (int i = 0; i < steps; ++i) sum += phase(s, (2 * i + 1.0) / steps - 1);
        return sum / steps;
    };
    CHECK(mean(of_type(2)) == Approx(1.15331).epsilon(1e-4));
    CHECK(mean(of_type(3)) == Approx(1.24680).epsilon(1e-4));
    CHECK(mean(of_type(4)) == Approx(1.06583).epsilon(1e-4));
    for (const double g : {-0.7, 0.0, 0.4}) CHECK(mean(of_type(5, g)) == Approx(1).epsilon(1e-4));
}

TEST_CASE("densities multiply, and coefficients of several media add up", "[medium]") {
    Media haze, glow;
    haze.absorption = Rgb(1, 0.5, 0);
    haze.scattering = of_type(1);
    haze.scattering.extinction = 0.5;
    haze.densities.resize(2);
    haze.densities[0].colour = {Rgb(0.5, 1, 2), 0.3, 0.2};
    haze.densities[1].colour.rgb = Rgb(3);
    glow.emission = Rgb(0, 0, 2);
    CHECK(density(haze, Vec3(0), {}) == Rgb(1.5, 3, 6));
    CHECK(max_density(haze) == Rgb(1.5, 3, 6));
    CHECK(haze.homogeneous());
    const std::array<const Media*, 2> both = {&haze, &glow};
    const MediumPoint here = coefficients(both, Vec3(0), {});
    CHECK(here.extinction == Rgb(1.5, 3, 6) * Rgb(1.5, 1, 0.5));
    CHECK(here.emission == Rgb(0, 0, 2));
    CHECK(here.scattering == Rgb(1.5, 3, 6));
}

TEST_CASE("a transformation moves densities, and no coefficient", "[medium]") {
    Media media;
    media.absorption = Rgb(2);
    media.densities.resize(1);
    const Media moved = transformed(media, Transform::translation(Vec3(1, 2, 3)));
    CHECK(moved.absorption == Rgb(2));
    CHECK(moved.densities[0].transform.point(Vec3(0)) == Vec3(1, 2, 3));
}

}  // namespace candelabra
