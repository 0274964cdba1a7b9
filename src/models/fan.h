// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulates faces with many corners and checks indices, for the readers of files.
#pragma once

#include "models/polyhedron.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace candelabra {

namespace polyhedra {

/// Splits a face into triangles by the diagonals from its first corner. Correct for convex faces;
/// modellers write others only by mistake.
inline void add_fan(std::span<const int> corners, std::vector<Polyhedron::Face>& faces) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        faces.push_back({corners[0], corners[i - 1], corners[i]});
}

/// Converts a number of a file to an index; -1 when it cannot be one.
template <class Number>
int place(Number number) {
    const bool fits = number >= 0 && number < std::numeric_limits<int>::max();
    return fits ? static_cast<int>(number) : -1;
}

/// Describes the first index of a face that is out of range; empty when there is none.
inline std::string wrong_place(std::span<const Polyhedron::Face> faces, std::size_t count,
                               const char* what) {
    for (const Polyhedron::Face& face : faces)
        for (const int i : face)
            if (i < 0 || static_cast<std::size_t>(i) >= count)
                return "a face names " + std::string(what) +
                       (i < 0 ? "" : " " + std::to_string(i)) + " that is not there: there are " +
                       std::to_string(count) + ", counted from 0";
    return {};
}

/// Describes the first of the points, or other lists of numbers, with a number that is not finite;
/// empty when there is none.
template <class List>
std::string not_finite(const List& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double number : points[i])
            if (!std::isfinite(number))
                return "a number of entry " + std::to_string(i) + " is not finite";
    return {};
}

}  // namespace polyhedra

}  // namespace candelabra
