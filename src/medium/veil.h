// SPDX-License-Identifier: GPL-3.0-or-later
// What a medium without scattering samples makes of the radiance from behind it.
#pragma once

#include "base/vector.h"

namespace candelabra {

struct Veil {
    Vec3 transmittance = Vec3(1);
    Vec3 added = Vec3(0);  ///< radiance

    Vec3 through(const Vec3& behind) const { return added + transmittance * behind; }
    /// Both: this one in front of the other.
    Veil before(const Veil& other) const {
        return {transmittance * other.transmittance, through(other.added)};
    }
};

}  // namespace candelabra
