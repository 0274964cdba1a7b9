// SPDX-License-Identifier: GPL-3.0-or-later
// Fractals in the complex plane, which is the plane z = 0: Mandelbrot and Julia sets for an
// exponent, and the magnet fractals.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

/// Maximum number of iterations that a pattern may ask for.
inline constexpr double max_iterations = 1e6;

/// Values of points inside and outside of the set, computed from the last point of their orbit,
/// a+bi.
struct FractalColouring {
    int exterior = 1;
    double exterior_factor = 1;
    int interior = 0;
    double interior_factor = 1;
};

struct Mandel : FractalColouring {
    int iterations = 1;
    int exponent = 2;

    static const ItemInfo vocabulary;
};

struct JuliaPattern : FractalColouring {
    Vec2 constant = Vec2(0);
    int iterations = 1;
    int exponent = 2;

    static const ItemInfo vocabulary;
};

struct Magnet : FractalColouring {
    int type = 1;
    int mandel = 0;
    std::optional<Vec2> julia;
    int julia_iterations = 0;

    static const ItemInfo vocabulary;
};

double evaluate(const Mandel&, const Vec3& point);
double evaluate(const JuliaPattern&, const Vec3& point);
double evaluate(const Magnet&, const Vec3& point);

}  // namespace candelabra
