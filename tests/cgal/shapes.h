// SPDX-License-Identifier: GPL-3.0-or-later
// Small polyhedra for tests, and functions that measure them.
#pragma once

#include "meshing/library.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>

namespace candelabra {

inline const Polyhedra& the_polyhedra() {
    Diagnostics diagnostics;
    const Polyhedra* found = modelling_library(diagnostics, {});
    REQUIRE(found);
    return *found;
}

/// For operations whose work nobody limits.
inline void uncounted(std::uint64_t) {}

/// A cube with edges of length 1 and its low corner at (x, y, z).
inline Polyhedron unit_cube(double x, double y, double z) {
    std::vector<Polyhedron::Point> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)});
    return {corners,
            {{0, 2, 3},
             {0, 3, 1},
             {4, 5, 7},
             {4, 7, 6},
             {0, 1, 5},
             {0, 5, 4},
             {2, 6, 7},
             {2, 7, 3},
             {0, 4, 6},
             {0, 6, 2},
             {1, 3, 7},
             {1, 7, 5}}};
}

/// Volume within a closed surface; positive when its faces are counterclockwise from outside.
inline double volume(const Polyhedron& solid) {
    double six = 0;
    const auto at = [&](int i) {
        const auto& p = solid.points[static_cast<std::size_t>(i)];
        return Vec3(p[0], p[1], p[2]);
    };
    for (const auto& [a, b, c] : solid.faces) six += dot(at(a), cross(at(b), at(c)));
    return six / 6;
}

}  // namespace candelabra
