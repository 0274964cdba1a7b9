// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/lamp_tilt.h"

#include <algorithm>
#include <cstddef>

namespace candelabra {

double factor_of_tilt(const LampTilt& tilt, double degrees) {
    const std::vector<double>& angles = tilt.angles;
    if (angles.empty()) return 1;
    if (angles.back() <= 90 && degrees > 90) degrees = 180 - degrees;
    const auto above = std::ranges::upper_bound(angles, degrees);
    if (above == angles.begin()) return tilt.factors.front();
    if (above == angles.end()) return tilt.factors.back();
    const auto high = static_cast<std::size_t>(above - angles.begin());
    const double share = (degrees - angles[high - 1]) / (angles[high] - angles[high - 1]);
    return tilt.factors[high - 1] + share * (tilt.factors[high] - tilt.factors[high - 1]);
}

}  // namespace candelabra
