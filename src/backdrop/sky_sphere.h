// SPDX-License-Identifier: GPL-3.0-or-later
// An infinite sphere around the scene: pigments by the direction of the ray. Evaluated by the
// renderer where a ray meets nothing.
#pragma once

#include "base/rgb.h"
#include "surface/pigment.h"

#include <vector>

namespace candelabra {

struct SkySphere {
    std::vector<Pigment> pigments;  ///< the last one is on top
    Rgb emission = Rgb(1);          ///< factor of all of them
    bool luminaire = false;         ///< whether it lights the scene

    static const ItemInfo vocabulary;
};

/// Radiance from a unit direction, over the background's. `old_rules` selects the blending of
/// pigments in languages before 3.7.
Rgb radiance(const SkySphere&, const Vec3& direction, const Rgb& background, const PatternScene&,
             bool old_rules);

}  // namespace candelabra
