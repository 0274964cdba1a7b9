// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings as sorted lists, so that tests can compare them with what they expect.
#pragma once

#include "base/ray.h"

namespace candelabra {

/// All crossings of a shape with the line of the ray, from the first to the last.
template <class T>
std::vector<Crossing> hits(const T& shape, const Ray& ray) {
    Crossings found;
    crossings(shape, ray, found);
    std::vector<Crossing> result;
    for (std::size_t i = 0; i < found.size(); ++i) result.push_back(found[i]);
    std::stable_sort(result.begin(), result.end(),
                     [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return result;
}

struct ExpectedHit {
    double t;
    Vec3 normal;
    bool entering;
};

/// One row of a table: a ray and what it must meet.
struct RayCase {
    Ray ray;
    std::vector<ExpectedHit> expected;
};

/// Whether the shape answers as the row says, to within a tolerance in t and in each component of
/// the normals.
template <class T>
bool answers(const T& shape, const RayCase& row, double tolerance = 1e-12) {
    const std::vector<Crossing> found = hits(shape, row.ray);
    if (found.size() != row.expected.size()) return false;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const ExpectedHit& e = row.expected[i];
        if (!(std::abs(found[i].t - e.t) <= tolerance * std::fmax(1, std::abs(e.t)))) return false;
        if (!(max_abs_component(found[i].normal - e.normal) <= tolerance) ||
            found[i].entering != e.entering)
            return false;
    }
    return true;
}

}  // namespace candelabra
