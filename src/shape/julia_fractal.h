// SPDX-License-Identifier: GPL-3.0-or-later
// A 3D slice of a Julia set of four-component numbers: the points whose orbits stay bounded. Rays
// march through it in steps that the escape of the orbits allows.
#pragma once

#include "base/ray.h"
#include "vocabulary/item_info.h"

namespace candelabra {

enum JuliaAlgebra : int { quaternions, hypercomplex_numbers };

enum JuliaFunction : int {
    julia_sqr,
    julia_cube,
    julia_exp,
    julia_ln,
    julia_reciprocal,
    julia_sin,
    julia_asin,
    julia_sinh,
    julia_asinh,
    julia_cos,
    julia_acos,
    julia_cosh,
    julia_acosh,
    julia_tan,
    julia_atan,
    julia_tanh,
    julia_atanh,
    julia_pwr,
};

struct JuliaFractal {
    Vec4 parameter = Vec4(1, 0, 0, 0);
    int algebra = quaternions;
    int function = julia_sqr;
    Vec2 exponent = Vec2(0);
    int max_iteration = 20;
    double precision = 20;
    Vec4 slice = Vec4(0, 0, 0, 1);
    double distance = 0;

    static const ItemInfo vocabulary;
};

/// Error that the ranges of single fields do not exclude, as a sentence; empty when there is none.
std::string problem(const JuliaFractal&);

Box bounds(const JuliaFractal&);
void crossings(const JuliaFractal&, const Ray&, Crossings&);
void crossings_between(const JuliaFractal&, const Ray&, const Interval&, Crossings&);
void nearest_crossings(const JuliaFractal&, const Ray&, const Interval&, Crossings&);
bool inside(const JuliaFractal&, const Vec3&);

/// Whether the function is a formula of complex numbers. Where a ray meets such a set depends on
/// where the ray starts: see julia_formula.h.
bool is_by_formula(const JuliaFractal&);

}  // namespace candelabra
