// SPDX-License-Identifier: GPL-3.0-or-later
// Textures at less than full quality, as POV-Ray's Quality option (+Q) has it. Asked while a world
// is compiled.
#pragma once

#include "surface/texture.h"

namespace candelabra {

/// The qualities at which something more is shown.
enum Quality : int {
    quality_light = 2,       ///< ambient and light; below it there are plain colours
    quality_shadows = 4,     ///< with lights of no size
    quality_areas = 5,       ///< area lights
    quality_pigments = 6,    ///< no quick colours, and what is behind transparent surfaces
    quality_reflection = 8,  ///< and normals
    quality_full = 9         ///< and what is in the air
};

/// The texture as it is shown at a quality: the same one when nothing changes.
Handle<Texture> simplified(const Handle<Texture>&, int quality);

}  // namespace candelabra
