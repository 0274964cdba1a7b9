// SPDX-License-Identifier: GPL-3.0-or-later
// Places between surfaces where media scatter the light of light paths.
#pragma once

#include "medium/media.h"
#include "transport/lit_region.h"
#include "world/world.h"

#include <optional>

namespace candelabra {

/// Whether media scatter light, and reflected luminaires can stand for all that they scatter. Fog,
/// rainbows, photons, media beside openings of their solids, and media whose solids cast no shadow
/// follow rules of POV-Ray that differ between a ray and a line between two places.
bool stands_for_scattering(const World&);

/// Whether all light is that of luminaires, light sources and a sky that is a luminaire, although
/// media may scatter it. Precondition: stands_for_scattering().
bool lamps_light_air(const World&);

/// A place on a line of light.
struct PlaceOnLine {
    double distance = 0;    ///< from the line's origin
    double stands_for = 0;  ///< length of the line: 1 over the density of the place
};
/// Draws a place where media may scatter light, before that distance, which may be infinite: near
/// the line's origin as far as light gets in the media, or about the region. The ray's direction is
/// a unit vector. Nothing if the line has no length.
std::optional<PlaceOnLine> place_on_line(MediaView, const Ray&, double distance, const LitRegion&,
                                         const PatternScene&, const Key&);

}  // namespace candelabra
