// SPDX-License-Identifier: GPL-3.0-or-later
// A point where light passes through a transparent surface.
#pragma once

#include "base/ray.h"
#include "base/rgb.h"
#include "world/geometry.h"

#include <cstdint>

namespace candelabra {

class World;

struct Passage {
    double t;  ///< distance along the ray
    PrimitiveIndex primitive;
    Vec3 normal;  ///< of any length
    std::uint32_t part = 0;
};

/// Fraction of light that the surface transmits, per channel.
Rgb passed(const World&, const Passage&, const Ray&);

}  // namespace candelabra
