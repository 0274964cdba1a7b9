// SPDX-License-Identifier: GPL-3.0-or-later
// How two pixels are compared by the rules of antialiasing that POV-Ray has.
#pragma once

#include "base/rgb.h"
#include "scene/settings.h"

namespace candelabra {

/// The value of a pixel for comparisons with others.
struct DisplayValue {
    Rgb colour = Rgb(0);
    double clear = 0;  ///< transparency, if the picture has an alpha channel
};

/// Decides whether two values differ.
struct Contrast {
    double threshold;      ///< maximum difference, summed over the channels
    double assumed_gamma;  ///< of the colours in the film
    double gamma;          ///< of the compared colours
    double exposure = 1;   ///< factor on the radiance for display

    DisplayValue shown(const Rgb& colour, double clear) const;
    bool between(const DisplayValue&, const DisplayValue&) const;
};

/// `exposure`: the factor on the radiance for display.
Contrast contrast_of(const RenderSettings&, double assumed_gamma, double exposure = 1);

}  // namespace candelabra
