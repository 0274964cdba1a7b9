// SPDX-License-Identifier: GPL-3.0-or-later
// The language measures angles in degrees, mathematics in radians. Used for the conversion.
#pragma once

#include <numbers>

namespace candelabra {

inline constexpr double radians_per_degree = std::numbers::pi / 180;

}  // namespace candelabra
