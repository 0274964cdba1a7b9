// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of a medium without scattering samples on the radiance from behind it.
#pragma once

#include "base/rgb.h"

namespace candelabra {

struct Veil {
    Rgb transmittance = Rgb(1);
    Rgb added = Rgb(0);  ///< radiance

    Rgb through(const Rgb& behind) const { return added + transmittance * behind; }
    /// Returns the combination of both, with this one in front.
    Veil before(const Veil& other) const {
        return {transmittance * other.transmittance, through(other.added)};
    }
};

}  // namespace candelabra
