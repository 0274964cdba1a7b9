// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a light sampling strategy.
#pragma once

#include <cstdint>
#include <vector>

namespace candelabra {

using LightIndex = std::uint32_t;

/// Stands for the sky where it is one of the lights that a strategy chooses among. No other light
/// has this index.
inline constexpr LightIndex sky_light = 0xfffffffe;

/// A light to which to trace a shadow ray.
struct LightPick {
    LightIndex light;
    double expected;  ///< expected number of times it is picked here; above 0
};
using LightPicks = std::vector<LightPick>;

}  // namespace candelabra
