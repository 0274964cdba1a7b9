// SPDX-License-Identifier: GPL-3.0-or-later
// Which finishes reflect diffusely as Lambert's law says: the one place that knows it.
#pragma once

#include "surface/finish.h"

namespace candelabra {

/// Whether its diffuse reflection is the same in all directions of one side, for all samples. Light
/// that spreads below the surface is apart.
inline bool is_lambertian(const Finish& f) {
    return !f.microfacet.on && f.diffuse_back == 0 && f.irid.amount == 0 && f.crand == 0 &&
           !f.conserve_energy;
}

}  // namespace candelabra
