// SPDX-License-Identifier: GPL-3.0-or-later
// Fraction of light that GGX facets reflect at once, over all directions. The rest goes from facet
// to facet or into the base below.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// By Schlick's approximation, the albedo is linear in the reflectance at normal incidence.
struct FacetAlbedo {
    double all = 1;      ///< of facets that reflect all light
    double grazing = 0;  ///< of facets that reflect the fraction (1 - cosine)^5

    double schlick(double facing) const { return facing * (all - grazing) + grazing; }
};

/// The albedo for a direction at this cosine to the surface's normal, and its cosine-weighted mean
/// over all directions. Roughness and cosine are from 0 to 1. The error is below 0.01 from a cosine
/// of 0.01 on, and below 0.004 from 0.1 on.
FacetAlbedo facet_albedo(double roughness, double cosine);
FacetAlbedo mean_facet_albedo(double roughness);

}  // namespace candelabra
