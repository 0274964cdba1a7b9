// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a box with the expected one, to the precision that POV-Ray prints.
#pragma once

#include "base/box.h"

namespace candelabra {

inline bool is(const Box& box, const Vec3& low, const Vec3& high) {
    return length(box.low - low) < 1e-4 && length(box.high - high) < 1e-4;
}

}  // namespace candelabra
