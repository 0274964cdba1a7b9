// SPDX-License-Identifier: GPL-3.0-or-later
// How far two colours are from each other.
#pragma once

#include "base/rgb.h"

namespace candelabra {

/// As of a vector.
inline double length(const Rgb& c) { return length(vec3_of(c)); }

}  // namespace candelabra
