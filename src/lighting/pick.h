// SPDX-License-Identifier: GPL-3.0-or-later
// What a light sampling strategy answers.
#pragma once

#include "luminaire/luminaire.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

using LightIndex = std::uint32_t;

/// A luminaire to send a shadow ray to.
struct LightPick {
    LightIndex light;
    double expected;  ///< expected number of times it is picked here; above 0
};
using LightPicks = std::vector<LightPick>;

/// Everything a strategy is built from. The luminaires outlive it.
struct LightScene {
    std::span<const Luminaire> luminaires;
    /// Bounds of the finite primitives: where points to be lit may be.
    std::span<const Box> surfaces;
    std::span<const Plane> planes = {};  ///< the unbounded ones, in world space
    std::optional<Vec3> eye = {};        ///< where most points to be lit are seen from
    double pixel = 0.004;                ///< angle that a pixel of the picture fills, in radians
};

}  // namespace candelabra
