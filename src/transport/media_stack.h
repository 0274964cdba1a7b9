// SPDX-License-Identifier: GPL-3.0-or-later
// The solids that a ray is in, and the media that are in them: POV-Ray 3.7's rules for interiors
// inside of each other.
#pragma once

#include "surface/dispersion.h"
#include "world/world.h"

#include <optional>

namespace candelabra {

/// By a primitive of each solid, in the order of entering.
using MediaStack = EnteredSolids;

/// The interior of the innermost solid; the atmosphere's where there is none.
const Interior& innermost(const World&, const MediaStack&);

/// Whether fog and rainbows are around: all solids are hollow.
bool in_atmosphere(const World&, const MediaStack&);

/// Whether the solid of that primitive is among them.
bool is_in(const World&, const MediaStack&, PrimitiveIndex);

/// What happens to a ray that goes through a surface.
struct Interface {
    /// Index of refraction in front of the surface over the one behind it, for the ray's colour.
    double ratio = 1;
    double plain = ratio;  ///< the same of white light, which tells how much is reflected
    MediaStack behind = {};
    double dispersion = 1;  ///< the same ratio of dispersions
    int bands = 0;          ///< into which white light is split; 0: it is not
};
/// Of a ray in those solids that meets the primitive; `band`: its colour, when it has one.
Interface interface_at(const World&, const MediaStack&, PrimitiveIndex,
                       const std::optional<SpectralBand>& band);

}  // namespace candelabra
