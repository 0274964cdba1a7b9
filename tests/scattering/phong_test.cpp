// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/phong.h"

#include "support/rgb.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Bench {
    Finish finish;
    Shading shading;

    Bench() {
        shading.view = unit(Vec3(0, -1, 1));
        shading.normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Rgb(0.8, 0.5, 0.2)};
    }
};

}  // namespace

TEST_CASE("diffuse light goes with a power of the cosine", "[render]") {
    Bench b;
    b.finish.diffuse = 0.7;
    b.finish.brilliance = 3;
    const Vec3 direction = unit(Vec3(3, 4, 0));
    CHECK(length(finish_response(b.shading, direction) - Rgb(0.8, 0.5, 0.2) * (0.7 * 0.512)) <
          1e-12);
}

TEST_CASE("grain belongs to the diffuse part", "[render]") {
    Bench b;
    b.finish.crand = 0.2;
    const Vec3 up(0, 1, 0);
    CHECK(finish_response(b.shading, up, {}, 0.5).r == Approx(0.8 * (0.6 - 0.1)));
    CHECK(finish_response(b.shading, up, {.diffuse = false}, 0.5) == Rgb(0));
}

TEST_CASE("light from below the horizon counts only for both_sides", "[render]") {
    Bench b;
    CHECK(finish_response(b.shading, Vec3(0, -1, 0)) == Rgb(0));
    b.shading.both_sides = true;
    CHECK(finish_response(b.shading, Vec3(0, -1, 0)).r == Approx(0.48));
}

TEST_CASE("with use_alpha highlights of a clear surface are weaker", "[scattering]") {
    for (const bool phong : {true, false}) {
        Bench b;
        b.finish.diffuse = 0;
        b.shading.opacity = 0.25;
        (phong ? b.finish.phong : b.finish.specular) = 0.8;
        const Vec3 mirror = unit(Vec3(0, 1, 1));
        CHECK(finish_response(b.shading, mirror).r == Approx(0.8));
        b.finish.use_alpha = true;
        CHECK(finish_response(b.shading, mirror).r == Approx(0.2));
    }
}

TEST_CASE("highlights are brightest in the mirror direction", "[render]") {
    Bench b;
    b.finish.diffuse = 0;
    const Vec3 mirror = unit(Vec3(0, 1, 1));
    for (const bool phong : {true, false}) {
        (phong ? b.finish.phong : b.finish.specular) = 0.5;
        CHECK(finish_response(b.shading, mirror).r == Approx(0.5));
        CHECK(finish_response(b.shading, unit(Vec3(0.2, 1, 1))).r < 0.5);
        CHECK(finish_response(b.shading, mirror, {.highlights = false}) == Rgb(0));
        b.finish = Finish{};
        b.finish.diffuse = 0;
    }
}

}  // namespace candelabra
