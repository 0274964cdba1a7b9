// SPDX-License-Identifier: GPL-3.0-or-later
// The sun of a daylight sky, as a light source.
#pragma once

#include "backdrop/daylight.h"
#include "scene/scene.h"

#include <optional>

namespace candelabra {

/// The sun as parallel light, from beyond all scenes; nothing if there is no such sky, or no sun in
/// it. `statement`: of the sky.
std::optional<PlacedLight> sun_of(const std::optional<DaylightSky>& sky, const Span& statement);

}  // namespace candelabra
