// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a box is the one that is expected, as exactly as POV-Ray prints it.
#pragma once

#include "base/box.h"

namespace candelabra {

inline bool is(const Box& box, const Vec3& low, const Vec3& high) {
    return length(box.low - low) < 1e-4 && length(box.high - high) < 1e-4;
}

}  // namespace candelabra
