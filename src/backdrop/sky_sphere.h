// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere without size around the scene: pigments by the direction of the ray. Asked by the
// renderer where a ray meets nothing.
#pragma once

#include "surface/pigment.h"

#include <vector>

namespace candelabra {

struct SkySphere {
    std::vector<Pigment> pigments;  ///< the last one is the nearest
    Vec3 emission = Vec3(1);        ///< times all of them
    bool luminaire = false;         ///< lights the scene

    static const ItemInfo vocabulary;
};

/// Radiance from a unit direction, over the background's. Languages before 3.7 mixed their pigments
/// by other rules: `old_rules`.
Vec3 radiance(const SkySphere&, const Vec3& direction, const Vec3& background, const PatternScene&,
              bool old_rules);

}  // namespace candelabra
