// SPDX-License-Identifier: GPL-3.0-or-later
// Response of POV-Ray 3.7's finish: ambient, emission, diffuse, phong and specular terms, and the
// colours of thin films.
#pragma once

#include "base/rgb.h"
#include "scattering/shading.h"

namespace candelabra {

/// Radiance towards the viewer without any light. `emission` is a factor of the finish's emission.
Rgb own_radiance(const Shading&, const ShadingRules&, double emission = 1);

/// Factor of an iridescent finish for light from a direction, or for a reflection towards it.
Rgb iridescence(const Shading&, const ShadingRules&, const Vec3& direction);

/// Terms of a finish.
struct FinishTerms {
    bool diffuse = true;
    bool highlights = true;
    bool brilliance = true;  ///< false: as if it were 1
};

/// Radiance towards the viewer due to light of colour 1 (in POV-Ray's sense: perpendicular
/// irradiance pi) from a unit direction, including the cosine. Zero if the direction is below the
/// horizon. `grain` is a random number for `crand`, the same for all channels.
Rgb finish_response(const Shading&, const Vec3& to_light, FinishTerms = {}, double grain = 0);

}  // namespace candelabra
