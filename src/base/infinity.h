// SPDX-License-Identifier: GPL-3.0-or-later
// The number beyond all others, by a name that is short.
#pragma once

#include <limits>

namespace candelabra {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace candelabra
