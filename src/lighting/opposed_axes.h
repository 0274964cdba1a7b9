// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the axes of luminaires that shine on both sides are summed: an axis has no sign.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// Whether the angle between two axes is surely above a right angle. The axes of walls that meet
/// are at right angles, and the rounding of their product must not decide how they are summed.
inline bool are_opposed(const Vec3& a, const Vec3& b) {
    constexpr double least_cosine = 1e-9;
    const double product = dot(a, b);
    return product < 0 && product * product > least_cosine * least_cosine * dot(a, a) * dot(b, b);
}

}  // namespace candelabra
