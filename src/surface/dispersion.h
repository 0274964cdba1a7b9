// SPDX-License-Identifier: GPL-3.0-or-later
// White light as bands of the spectrum, for interiors whose index of refraction depends on the
// wavelength. Used by the renderer where a ray is split.
#pragma once

#include "base/rgb.h"

namespace candelabra {

/// One of several equal bands of the visible spectrum, counted from violet.
struct SpectralBand {
    int number = 0;
    int count = 1;

    /// Exponent of an interior's dispersion in the factor of its refractive index for this band:
    /// 1/2 at violet, -1/2 at red.
    double power() const { return 0.5 - (number + 0.5) / count; }
};

/// The band's colour. The mean over all bands is white (nearly: as in POV-Ray).
Rgb hue(const SpectralBand&);

}  // namespace candelabra
