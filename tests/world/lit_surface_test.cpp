// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/lit_surface.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Area of an ellipsoid, by a fine sum over its angles.
double ellipsoid(double a, double b, double c) {
    constexpr int steps = 800;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double u = pi * (i + 0.5) / steps, v = pi / 2 * (j + 0.5) / steps;
            const double s = std::sin(u), t = std::cos(u);
            sum += s * std::sqrt(b * b * c * c * s * s * std::cos(v) * std::cos(v) +
                                 a * a * c * c * s * s * std::sin(v) * std::sin(v) +
                                 a * a * b * b * t * t);
        }
    return 4 * sum * (pi / steps) * (pi / 2 / steps);
}

struct AreaCase {
    const char* object;
    double area;
    bool open = false;
};

std::vector<AreaCase> area_cases() {
    const double slant = std::sqrt(1 + 9);
    return {
        {"sphere { 1, 2 }", 16 * pi},
        {"sphere { 0, 1 scale <0.1, 0.2, 0.05> }", ellipsoid(0.1, 0.2, 0.05)},
        {"sphere { 0, 1 scale <1, 1, 5> rotate 33 }", ellipsoid(1, 1, 5)},
        {"box { 0, <1, 2, 3> }", 22},
        {"box { 0, 1 scale <1, 2, 3> rotate <10, 20, 30> }", 22},
        {"box { 0, 1 matrix <1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0> }", 4 + 2 * std::sqrt(2)},
        {"cylinder { 0, 3*y, 2 }", 2 * pi * 2 * 3 + 2 * pi * 4},
        {"cylinder { 0, 3*y, 2 open }", 2 * pi * 2 * 3, true},
        {"cone { 0, 1, 3*y, 0 }", pi * slant + pi},
        {"cone { 0, 2, 3*y, 1 scale 2 }", 4 * (3 * pi * slant + 5 * pi)},
        {"disc { 0, y, 2 }", 4 * pi, true},
        {"disc { 0, y, 2, 1 scale <1, 1, 3> }", 9 * pi, true},
        {"triangle { 0, 2*x, 3*y }", 3, true},
        {"polygon { 5, 0, 2*x, <2, 3, 0>, 3*y, 0 }", 6, true},
        {"mesh { triangle { 0, x, y } triangle { x, y, x + y } }", 1, true},
        {"mesh2 { vertex_vectors { 4, 0, x, y, z } face_indices { 4, <0, 1, 2>, <0, 2, 3>, <0, 3, "
         "1>, <3, 2, 1> } }",
         1.5 + std::sqrt(3) / 2},
        {"torus { 2, 0.5 }", 4 * pi * pi * 2 * 0.5},
        {"torus { 2, 0.5 scale 0.1 rotate 40 }", 0.04 * pi * pi},
        {"superellipsoid { <1, 1> }", 4 * pi},
        {"quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -4 bounded_by { sphere { 0, 2.1 } } }",
         16 * pi},
        {"sphere_sweep { linear_spline 2, 0, 1, 4*y, 1 }", 4 * pi + 8 * pi},
        {"blob { threshold 0.5 sphere { 0, 2, 1 } }", 4 * pi * 4 * (1 - std::sqrt(0.5))},
        {"lathe { linear_spline 5, <0, 0>, <1, 0>, <1, 2>, <0, 2>, <0, 0> }", 6 * pi},
        {"sor { 4, <1, -1>, <1, 0>, <1, 1>, <1, 2> }", 4 * pi},
        {"prism { linear_sweep linear_spline 0, 2, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }",
         10},
        {"ovus { 1, 1 }", -1},
        {"isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } "
         "max_gradient 3 }",
         4 * pi},
        {"bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 <0,0,0>, <1,0,0>, <2,0,0>, "
         "<3,0,0>, "
         "<0,1,0>, <1,1,0>, <2,1,0>, <3,1,0>, <0,2,0>, <1,2,0>, <2,2,0>, <3,2,0>, <0,3,0>, "
         "<1,3,0>, <2,3,0>, <3,3,0> }",
         9, true},
        {"parametric { function { u }, function { 0 }, function { v } <0, 0>, <2, 3> "
         "contained_by { box { -1, 4 } } max_gradient 2 }",
         6, true},
        {"difference { sphere { 0, 1 } plane { y, 0 inverse } }", -1},
        {"intersection { sphere { 0, 1 } box { <0, -2, -2>, 2 } }", 3 * pi},
        {"sphere { 0, 1 clipped_by { plane { y, 0 } } }", 2 * pi, true},
        {"merge { sphere { 0, 1 } sphere { x, 1 } }", 2 * 4 * pi * 0.75},
    };
}

/// Of all surfaces that glow.
struct Total {
    double area = 0, pieces = 0;
    bool open = false;
};
Total total(const std::string& object, bool places) {
    const SharedWorld world = world_of("#version 3.7; object { " + object +
                                       " pigment { rgb 1 } finish { emission 1 } } plane { y, -9 "
                                       "pigment { rgb 1 } }");
    Total sum;
    for (const Luminaire& each : world->lights.luminaires.own()) {
        const LitSurface surface = lit_surface(*world, each.primitive, {.places = places});
        sum.area += surface.area;
        sum.open = sum.open || surface.open;
        for (const SurfacePiece& piece : surface.pieces) {
            sum.pieces += piece.area;
            REQUIRE(length(piece.normal) == Approx(1));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("the area of a luminaire is right within a thousandth, whatever its shape", "[world]") {
    for (const AreaCase& each : area_cases()) {
        if (each.area < 0) continue;
        CAPTURE(each.object);
        for (const bool places : {false, true}) {
            const Total found = total(each.object, places);
            CHECK(found.area == Approx(each.area).epsilon(1e-3));
            CHECK(found.pieces == Approx(each.area).epsilon(1e-3));
            const bool mesh = std::string_view(each.object).starts_with("mesh");
            if (!mesh) CHECK(found.open == each.open);
        }
    }
}

}  // namespace candelabra
