// SPDX-License-Identifier: GPL-3.0-or-later
// The input and the result of a light sampling strategy.
#pragma once

#include "base/ray.h"
#include "luminaire/luminaire.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candelabra {

using LightIndex = std::uint32_t;

/// A luminaire to which to trace a shadow ray.
struct LightPick {
    LightIndex light;
    double expected;  ///< expected number of times it is picked here; above 0
};
using LightPicks = std::vector<LightPick>;

/// The data from which a strategy is built. The luminaires must outlive it.
struct LightScene {
    std::span<const Luminaire> luminaires;
    /// Bounds of the finite primitives, on which points to be lit may lie.
    std::span<const Box> surfaces;
    std::span<const Plane> planes = {};  ///< the unbounded ones, in world space
    std::optional<Vec3> eye = {};        ///< point from which most points to be lit are seen
    double view = 0;  ///< size of the view of a camera without an eye; 0: not known
    /// If all rays of the camera are parallel: one of them, from the plane in which they start.
    std::optional<Ray> axis = {};
    double pixel = 0.004;  ///< angle of a pixel of the picture, in radians
};

}  // namespace candelabra
