// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/mirror.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct MirrorBench {
    Finish finish;
    Shading shading;

    MirrorBench() {
        shading.view = unit(Vec3(0, -1, 1));
        shading.normal = shading.smooth_normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Rgb(0.8, 0.5, 0.2)};
    }
};

}  // namespace

TEST_CASE("reflection goes from straight on to grazing", "[render]") {
    MirrorBench b;
    b.finish.reflection = {Rgb(0.1), Rgb(0.9), false, 2, 1, 0};
    const double cosine = std::sqrt(0.5);
    CHECK(reflectivity(b.shading, 1).r == Approx(0.1 + 0.8 * (1 - cosine) * (1 - cosine)));
    b.finish.reflection = {Rgb(0), Rgb(1), true, 1, 1, 0};
    b.shading.view = Vec3(0, -1, 0);
    CHECK(reflectivity(b.shading, 1 / 1.5).r == Approx(0.04));
}

TEST_CASE("with use_alpha a clear surface reflects less", "[scattering]") {
    MirrorBench b;
    b.finish.reflection = {Rgb(0.4), Rgb(0.4), false, 1, 1, 0};
    b.shading.opacity = 0.25;
    CHECK(reflectivity(b.shading, 1).r == Approx(0.4));
    b.finish.use_alpha = true;
    CHECK(reflectivity(b.shading, 1).r == Approx(0.1));
}

TEST_CASE("rays are bent by Snell's law, and reflected where they cannot be", "[scattering]") {
    MirrorBench b;
    const Vec3 inside = refracted_direction(b.shading, 1 / 1.5);
    CHECK(inside.z == Approx(std::sqrt(0.5) / 1.5));
    CHECK(length(inside) == Approx(1));
    CHECK(length(reflected_direction(b.shading) - unit(Vec3(0, 1, 1))) < 1e-12);
    CHECK_FALSE(reflects_totally(b.shading, 1 / 1.5));
    CHECK(reflects_totally(b.shading, 1.5));
}

TEST_CASE("a bump mirrors no ray into the surface", "[scattering]") {
    MirrorBench b;
    b.shading.view = unit(Vec3(0, -0.1, 1));
    b.shading.normal = unit(Vec3(0, 1, 0.5));
    CHECK(reflected_direction(b.shading).y > 0);
}

}  // namespace candelabra
