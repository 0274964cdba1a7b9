// SPDX-License-Identifier: GPL-3.0-or-later
// White light as bands of the spectrum, for interiors whose index of refraction differs with the
// colour. Asked by the renderer where a ray is split.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// One of several equal bands of the visible spectrum, counted from violet.
struct SpectralBand {
    int number = 0;
    int count = 1;

    /// By which power of an interior's dispersion its index of refraction differs in this band:
    /// 1/2 at violet, -1/2 at red.
    double power() const { return 0.5 - (number + 0.5) / count; }
};

/// The band's colour, so that all bands together have the mean of white (nearly: as in POV-Ray).
Vec3 hue(const SpectralBand&);

}  // namespace candelabra
