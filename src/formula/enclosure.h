// SPDX-License-Identifier: GPL-3.0-or-later
// Interval arithmetic with slopes: bounds of a value and of its derivative while the arguments move
// along a line. Executes programs on intervals; isosurfaces use it to isolate their roots.
// Undefined values (the root of -1) are ignored.
#pragma once

#include "formula/program.h"

#include <limits>

namespace candelabra {

/// The numbers from low to high. Neither bound is NaN.
struct Bounds {
    double low = 0, high = 0;

    bool contains(double x) const { return low <= x && x <= high; }
    bool single() const { return low == high; }
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

inline constexpr Bounds all_numbers{-std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity()};

Bounds operator+(const Bounds&, const Bounds&);
Bounds operator-(const Bounds&, const Bounds&);
Bounds operator*(const Bounds&, const Bounds&);
/// Returns all numbers if the divisor may be 0.
Bounds operator/(const Bounds&, const Bounds&);
Bounds hull(const Bounds&, const Bounds&);

struct Enclosure {
    Bounds value;
    Bounds slope;  ///< all numbers if the value may jump

    static Enclosure constant(double x) { return {{x, x}, {0, 0}}; }
    static constexpr Enclosure unknown() { return {all_numbers, all_numbers}; }
    friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// Encloses the operation. Precondition: only_computes() holds, and it is not Operation::apply.
Enclosure enclosed(Operation, const Enclosure& a, const Enclosure& b);

/// Executes the program on intervals. As for execute(), inputs must be in their registers;
/// constants are stored by this function. Returns false if no bounds are known, because the program
/// calls C++ code or takes too many steps.
bool enclose(const Program&, Enclosure* registers);

}  // namespace candelabra
