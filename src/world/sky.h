// SPDX-License-Identifier: GPL-3.0-or-later
// The surroundings of a world's surfaces. Filled by compile().
#pragma once

#include "backdrop/background.h"
#include "backdrop/daylight.h"
#include "backdrop/rainbow.h"
#include "backdrop/sky_light.h"
#include "backdrop/sky_sphere.h"
#include "medium/fog.h"
#include "medium/media.h"

#include <optional>
#include <vector>

namespace candelabra {

/// The background, and the media and fog on the way to it.
struct Sky {
    Background background;
    std::optional<DaylightSky> daylight;  ///< in the place of the background
    std::optional<SkySphere> sphere;      ///< before it
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::vector<Media> media;  ///< outside of solids
    SkyLight light;            ///< empty unless the sky is a luminaire
};

}  // namespace candelabra
