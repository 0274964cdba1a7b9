// SPDX-License-Identifier: GPL-3.0-or-later
// Which finishes are Lambertian. The only place that decides this.
#pragma once

#include "surface/finish.h"

namespace candelabra {

/// Whether the diffuse reflection is constant over all directions of one side and over all samples.
/// Subsurface scattering is not considered.
inline bool is_lambertian(const Finish& f) {
    return !f.microfacet.on && f.diffuse_back == 0 && f.irid.amount == 0 && f.crand == 0 &&
           !f.conserve_energy;
}

}  // namespace candelabra
