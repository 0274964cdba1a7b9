// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of random cells: cells, crackle and facets. Each unit cube of the lattice has one
// nucleus at a random position.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Cells {
    static const ItemInfo vocabulary;
};

struct Crackle {
    Vec3 form = Vec3(-1, 1, 0);
    Vec3 metric = Vec3(2);  ///< POV-Ray reads a vector and uses its x component
    double offset = 0;
    bool solid = false;
    Vec3 repeat = Vec3(0);  ///< period along each axis, its fraction cut off; below 1: none

    static const ItemInfo vocabulary;
};

/// A normal only (surface/bump); its value is always 0.
struct Facets {
    double size = 0.1;
    double coords = 0;
    double metric = 2;

    static constexpr std::string_view home = "normal";
    static const ItemInfo vocabulary;
};

double evaluate(const Cells&, const Vec3& point);
double evaluate(const Crackle&, const PatternPoint&);
double evaluate(const Facets&, const Vec3& point);

/// Returns the nucleus nearest to a point. Metric 2 is the Euclidean distance, 1 the signed sum of
/// the offsets, and any other the sum of their absolute values to that power, as in POV-Ray's
/// facets.
Vec3 nearest_nucleus(const Vec3& point, double metric);

}  // namespace candelabra
