// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/subsurface.h"

#include "vocabulary/written.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

/// All light that leaves a plane for an incident flux of 1.
Rgb total(const Dipole& dipole) {
    Rgb sum(0);
    const double step = 0.002;
    for (double log_radius = -16; log_radius < 16; log_radius += step) {
        const double radius2 = std::exp(2 * log_radius);
        sum += step * 2 * std::numbers::pi * radius2 * dipole.spread(radius2);
    }
    return sum;
}

}  // namespace

TEST_CASE("a dipole gives back as much light as it is made for", "[surface]") {
    const Rgb albedo(0.8, 0.5, 0.05);
    for (const double ior : {1.0, 1.3, 2.0})
        for (const double path : {0.01, 1.0, 30.0}) {
            const Rgb out = total(Dipole(albedo, path * Rgb(1, 2, 0.5), ior));
            for (int i = 0; i < 3; ++i) CHECK(out[i] == Approx(albedo[i]).epsilon(1e-4));
        }
}

TEST_CASE("a dipole is finite for surfaces that give back nothing or all", "[surface]") {
    const Dipole dipole(Rgb(0, 1, 2), Rgb(1), 1.5);
    for (const double distance2 : {0.0, 1.0, 1e6}) {
        const Rgb out = dipole.spread(distance2);
        for (int i = 0; i < 3; ++i) CHECK((out[i] >= 0 && std::isfinite(out[i])));
    }
}

TEST_CASE("far light has gone through more of what swallows it", "[surface]") {
    const Dipole dipole(Rgb(0.9, 0.5, 0.1), Rgb(1), 1.3);
    const Rgb near = dipole.spread(1), far = dipole.spread(100);
    CHECK(far.r / near.r > 3 * far.g / near.g);
    CHECK(far.g / near.g > 3 * far.b / near.b);
}

TEST_CASE("subsurface starts opaque, with POV-Ray's numbers of samples", "[surface]") {
    const Subsurface none;
    CHECK(written_fields(Subsurface::vocabulary, &none).empty());
    const SubsurfaceSettings settings;
    CHECK(settings.samples == 50);
    CHECK(settings.single_samples == 50);
    CHECK_FALSE(settings.on);
}

}  // namespace candelabra
