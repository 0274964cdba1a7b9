// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of a medium without scattering samples on the radiance from behind it.
#pragma once

#include "base/vector.h"

namespace candelabra {

struct Veil {
    Vec3 transmittance = Vec3(1);
    Vec3 added = Vec3(0);  ///< radiance

    Vec3 through(const Vec3& behind) const { return added + transmittance * behind; }
    /// Returns the combination of both, with this one in front.
    Veil before(const Veil& other) const {
        return {transmittance * other.transmittance, through(other.added)};
    }
};

}  // namespace candelabra
