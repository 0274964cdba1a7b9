// SPDX-License-Identifier: GPL-3.0-or-later
// The solids that a ray is in, and their media: POV-Ray 3.7's rules for nested interiors.
#pragma once

#include "surface/dispersion.h"
#include "world/world.h"

#include <optional>
#include <span>

namespace candelabra {

/// One primitive of each solid, in the order of entering.
using MediaStack = EnteredSolids;

/// Returns the interior of the innermost solid; that of the atmosphere if there is none.
const Interior& innermost(const World&, const MediaStack&);

/// Whether fog, rainbows and media outside of solids apply, because all solids are hollow.
bool in_atmosphere(const World&, std::span<const PrimitiveIndex> solids);
inline bool in_atmosphere(const World& world, const MediaStack& media) {
    return in_atmosphere(world, std::span<const PrimitiveIndex>(media.data(), media.size()));
}

/// Whether the primitive's solid is one of them.
bool is_in(const World&, const MediaStack&, PrimitiveIndex);

/// The change of media at a surface that a ray passes through.
struct Interface {
    /// Index of refraction in front of the surface over that behind it, for the ray's colour.
    double ratio = 1;
    double plain = ratio;  ///< the same for white light, which determines the reflectivity
    MediaStack behind = {};
    double dispersion = 1;  ///< the same ratio of dispersions
    int bands = 0;          ///< number of bands into which white light is split; 0: none
};
/// For a ray in those solids that meets the primitive. `band` is the ray's colour, if it has one.
Interface interface_at(const World&, const MediaStack&, PrimitiveIndex,
                       const std::optional<SpectralBand>& band);

}  // namespace candelabra
