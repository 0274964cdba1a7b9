// SPDX-License-Identifier: GPL-3.0-or-later
// Finds where a function of one number changes its sign, from what is known of its values and
// slopes: where a ray meets an isosurface. Pairs of sign changes are never torn apart: there is an
// odd number between two places exactly when the signs there differ.
#pragma once

#include "base/function_ref.h"
#include "base/ray.h"
#include "formula/enclosure.h"

#include <vector>

namespace candelabra {

struct LineFunction {
    FunctionRef<double(double)> at;
    /// Between which numbers its values and slopes lie in a range.
    FunctionRef<Enclosure(const Interval&)> within;
};

/// Whether a value belongs to the side below 0; what is no number does not.
inline bool is_below(double value) { return value <= 0; }

/// The unit normal of a surface that a ray enters or leaves, from the slope of the function that
/// grows outwards. Where the ray grazes the surface, or the function has an edge, the slope may say
/// otherwise than the ray; then it is mended.
Vec3 normal_against(const Vec3& slope, const Vec3& direction, bool entering);

/// The places in the range where is_below() changes, in ascending order. Changes that come back
/// within `detail` may be passed over. The work is bounded: a function that stays at 0, or changes
/// its sign very often, is not looked at more closely than that.
std::vector<double> sign_changes(const LineFunction&, const Interval& range, double detail);

struct SignChange {
    double t;
    bool below;  ///< behind it
};

/// Those of them that are in `wanted`, and maybe others.
std::vector<SignChange> changes_between(const LineFunction&, const Interval& range, double detail,
                                        const Interval& wanted);

/// Those of them that lie about the beginning of `wanted`, up to the first one in it, if there is
/// one.
std::vector<SignChange> nearest_changes(const LineFunction&, const Interval& range, double detail,
                                        const Interval& wanted);

}  // namespace candelabra
