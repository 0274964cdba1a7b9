// SPDX-License-Identifier: GPL-3.0-or-later
// The origin and the unit vectors of the axes, for tests of shapes and solids.
#pragma once

#include "base/vector.h"

namespace candelabra {

inline const Vec3 o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

}  // namespace candelabra
