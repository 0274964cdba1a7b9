// SPDX-License-Identifier: GPL-3.0-or-later
// What surrounds the surfaces of a world. Filled by compile().
#pragma once

#include "backdrop/rainbow.h"
#include "backdrop/sky_light.h"
#include "backdrop/sky_sphere.h"
#include "medium/fog.h"
#include "medium/media.h"

#include <optional>
#include <vector>

namespace candelabra {

/// What rays meet where they meet no surface, and on their way.
struct Sky {
    Background background;
    std::optional<SkySphere> sphere;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::vector<Media> media;  ///< outside of solids
    Box near;                  ///< where media are worth most effort; empty where there are none
    SkyLight light;            ///< empty unless the sky is a luminaire
};

}  // namespace candelabra
