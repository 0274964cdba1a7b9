// SPDX-License-Identifier: GPL-3.0-or-later
// A short name for infinity.
#pragma once

#include <limits>

namespace candelabra {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace candelabra
