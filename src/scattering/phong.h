// SPDX-License-Identifier: GPL-3.0-or-later
// How POV-Ray 3.7's finish answers light: ambient, emission, diffuse, phong and specular terms, and
// the colours of thin films.
#pragma once

#include "scattering/shading.h"

namespace candelabra {

/// Radiance that the surface sends to the viewer by itself. With `emission` false without that of
/// the finish.
Vec3 own_radiance(const Shading&, const ShadingRules&, bool emission = true);

/// By what light from a direction, or a reflection towards it, is multiplied where the finish is
/// iridescent.
Vec3 iridescence(const Shading&, const ShadingRules&, const Vec3& direction);

/// Terms of a finish.
struct FinishTerms {
    bool diffuse = true;
    bool highlights = true;
    bool brilliance = true;  ///< false: as if it were 1
};

/// Radiance towards the viewer when light of colour 1 (in POV-Ray's sense: perpendicular irradiance
/// pi) comes from a unit direction; the cosine is in it. Zero where the direction is below the
/// horizon. `grain` is a random number for `crand`, the same for all channels.
Vec3 finish_response(const Shading&, const Vec3& to_light, FinishTerms = {}, double grain = 0);

}  // namespace candelabra
