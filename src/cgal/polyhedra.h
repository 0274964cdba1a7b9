// SPDX-License-Identifier: GPL-3.0-or-later
// The operations of CGAL on triangle surfaces: hulls, boolean operations, subdivision,
// triangulations. CGAL's headers take minutes to compile, and its exact numbers need libraries of
// their own. So this module is a library that is opened when a scene first needs such an operation.
// Its interface has plain lists of points and faces only.
#pragma once

#include "models/polyhedron.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candelabra {

/// A step of a stack machine that builds a solid from others: each step pushes one solid. All kinds
/// but the first pop the two topmost ones.
enum class SolidOperation {
    take,       ///< the next of the given solids
    join,       ///< inside either
    intersect,  ///< inside both
    subtract,   ///< inside the lower one and not the upper one
};

/// Is told of steps of work, and may throw to end it.
using WorkCount = void (*)(std::uint64_t steps);

/// How a surface is divided and smoothed.
enum class SubdivisionRule {
    loop,  ///< Loop: every point moves; the limit has continuous curvature
    root3  ///< Kobbelt: three times as many faces per step
};

/// The entry points. Each returns an error or, with a complete result, an empty string.
struct Polyhedra {
    /// The convex hull of the points.
    std::string (*hull)(std::span<const Polyhedron::Point>, Polyhedron&);
    /// A solid from closed surfaces without self-intersections. Exact: coordinates are rounded
    /// once, at the end. `count` is called with the steps of work, see count_long_work(); what it
    /// throws ends the operation. Precondition: the steps leave one solid on the stack.
    std::string (*combine)(std::span<const SolidOperation>, std::span<const Polyhedron>,
                           WorkCount count, Polyhedron&);
    std::string (*subdivide)(const Polyhedron&, SubdivisionRule, int steps, Polyhedron&);
    /// The Delaunay triangulation of points in the plane.
    std::string (*triangulate)(std::span<const std::array<double, 2>>,
                               std::vector<Polyhedron::Face>&);
};

/// The name of the library, and of its one function: `const Polyhedra* candelabra_polyhedra()`.
inline constexpr auto polyhedra_library = "libcandelabra_cgal.so";
inline constexpr auto polyhedra_function = "candelabra_polyhedra";

}  // namespace candelabra
