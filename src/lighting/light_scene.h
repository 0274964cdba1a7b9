// SPDX-License-Identifier: GPL-3.0-or-later
// The input of a light sampling strategy.
#pragma once

#include "base/box.h"
#include "base/ray.h"
#include "lighting/choosable_lights.h"
#include "shape/plane.h"

#include <memory>
#include <optional>
#include <span>

namespace candelabra {

/// The data from which a strategy is built.
struct LightScene {
    std::shared_ptr<const ChoosableLights> lights;  ///< null: none
    /// Bounds of the finite primitives, on which points to be lit may lie.
    std::span<const Box> surfaces = {};
    std::span<const Plane> planes = {};  ///< the unbounded ones, in world space
    std::optional<Vec3> eye = {};        ///< point from which most points to be lit are seen
    double view = 0;  ///< size of the view of a camera without an eye; 0: not known
    /// If all rays of the camera are parallel: one of them, from the plane in which they start.
    std::optional<Ray> axis = {};
    double pixel = 0.004;  ///< angle of a pixel of the picture, in radians
    /// Fraction of the choices that a cell without a survey divides evenly among the entries of its
    /// cut: a defence against lights that are bright, near and occluded.
    double even = 0;

    std::size_t count() const { return lights ? lights->size() : 0; }
    bool has_sky() const { return lights && lights->sky(); }
};

}  // namespace candelabra
