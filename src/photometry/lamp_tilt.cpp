// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/lamp_tilt.h"

#include "base/between.h"

namespace candelabra {

double factor_of_tilt(const LampTilt& tilt, double degrees) {
    const std::vector<double>& angles = tilt.angles;
    if (angles.empty()) return 1;
    if (angles.back() <= 90 && degrees > 90) degrees = 180 - degrees;
    return place_between(angles, degrees).of(tilt.factors);
}

}  // namespace candelabra
