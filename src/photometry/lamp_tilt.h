// SPDX-License-Identifier: GPL-3.0-or-later
// How the light of a discharge lamp changes with its burning position: TILT of ANSI/IES LM-63.
#pragma once

#include <vector>

namespace candelabra {

/// Factors on all intensities by the tilt of the luminaire from the position in which it was
/// measured, aimed straight down.
struct LampTilt {
    int geometry = 1;  ///< 1: the lamp is vertical; 2: horizontal, and stays so; 3: tilts with it
    std::vector<double> angles, factors;  ///< degrees, rising, and as many factors, at least 0

    /// Whether the angle between the luminaire's aim and the vertical decides the factor. For a
    /// horizontal lamp its own direction does, which the file does not state.
    bool follows_aim() const { return geometry == 1; }
    friend bool operator==(const LampTilt&, const LampTilt&) = default;
};

/// The factor at a tilt in degrees, 0 to 180, linear between the angles. A table that ends at or
/// before 90 degrees counts in both directions from the horizontal; beyond its ends the nearest
/// factor holds. Without angles it is 1.
double factor_of_tilt(const LampTilt&, double degrees);

}  // namespace candelabra
