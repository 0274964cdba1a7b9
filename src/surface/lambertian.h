// SPDX-License-Identifier: GPL-3.0-or-later
// Which finishes are Lambertian. The only place that decides this.
#pragma once

#include "surface/finish.h"

namespace candelabra {

/// Whether what is reflected diffusely is constant over all directions of the side of the light,
/// and, if light passes from behind, over those of the other side; and over all samples.
/// Subsurface scattering is not considered.
inline bool is_even_on_each_side(const Finish& f) {
    return !f.microfacet.on && f.irid.amount == 0 && f.crand == 0 && !f.conserve_energy;
}
/// The same of a finish that no light passes.
inline bool is_lambertian(const Finish& f) {
    return is_even_on_each_side(f) && f.diffuse_back == 0;
}

}  // namespace candelabra
