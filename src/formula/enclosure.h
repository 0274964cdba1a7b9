// SPDX-License-Identifier: GPL-3.0-or-later
// Interval arithmetic with slopes: between which numbers a value lies, and its derivative, while
// the arguments move along a line. What programs do to numbers, done to intervals; isosurfaces find
// their roots with it. Values that are no numbers (the root of -1) do not count.
#pragma once

#include "formula/program.h"

#include <limits>

namespace candelabra {

/// Numbers from low to high; neither is NaN.
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
/// All numbers where the divisor may be 0.
Bounds operator/(const Bounds&, const Bounds&);
Bounds hull(const Bounds&, const Bounds&);

struct Enclosure {
    Bounds value;
    Bounds slope;  ///< all numbers where it may jump

    static Enclosure constant(double x) { return {{x, x}, {0, 0}}; }
    static constexpr Enclosure unknown() { return {all_numbers, all_numbers}; }
    friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// The operation, which only computes (see only_computes()) and is not Operation::apply.
Enclosure enclosed(Operation, const Enclosure& a, const Enclosure& b);

/// As execute(): inputs must be in their registers, constants are put there. False: nothing is
/// known, because the program calls code of C++, or is too long for this.
bool enclose(const Program&, Enclosure* registers);

}  // namespace candelabra
