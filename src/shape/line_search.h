// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the sign changes of a function of one variable from bounds of its values and slopes, where
// a ray meets an isosurface. Pairs of sign changes are never split: between two places there is an
// odd number of them exactly when the signs there differ.
#pragma once

#include "base/function_ref.h"
#include "base/ray.h"
#include "formula/enclosure.h"

#include <vector>

namespace candelabra {

struct LineFunction {
    FunctionRef<double(double)> at;
    /// Bounds of the function's values and slopes over a range.
    FunctionRef<Enclosure(const Interval&)> within;
};

/// Whether a value counts as below 0; NaN does not.
inline bool is_below(double value) { return value <= 0; }

/// Unit normal of a surface that a ray enters or leaves, from the gradient of the function, which
/// grows outwards. Where the ray grazes the surface, or the function has an edge, the gradient may
/// disagree with the ray; then the normal is corrected.
Vec3 normal_against(const Vec3& slope, const Vec3& direction, bool entering);

/// The places in the range where is_below() changes, in ascending order. Two changes less than
/// `detail` apart may be missed. The work is bounded: a function that stays at 0, or changes its
/// sign very often, is not resolved further.
std::vector<double> sign_changes(const LineFunction&, const Interval& range, double detail);

struct SignChange {
    double t;
    bool below;  ///< after the change
};

/// Finds the sign changes in `wanted`, and possibly others.
std::vector<SignChange> changes_between(const LineFunction&, const Interval& range, double detail,
                                        const Interval& wanted);

/// Finds sign changes near the beginning of `wanted`, up to the first one in it, if there is one.
std::vector<SignChange> nearest_changes(const LineFunction&, const Interval& range, double detail,
                                        const Interval& wanted);

}  // namespace candelabra
