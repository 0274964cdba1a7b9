// SPDX-License-Identifier: GPL-3.0-or-later
// Textures at reduced quality, as in POV-Ray's Quality option (+Q). Used while a world is compiled.
#pragma once

#include "surface/texture.h"

namespace candelabra {

/// The quality levels from which on more is shown.
enum Quality : int {
    quality_light = 2,       ///< ambient and light; below, plain colours
    quality_shadows = 4,     ///< shadows of lights of no size
    quality_areas = 5,       ///< area lights
    quality_pigments = 6,    ///< no quick colours, and light through transparent surfaces
    quality_reflection = 8,  ///< reflection and normals
    quality_full = 9         ///< media and fog too
};

/// Returns the texture as shown at a quality; the same handle if nothing changes.
Handle<Texture> simplified(const Handle<Texture>&, int quality);

}  // namespace candelabra
