// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/contrast.h"

#include "base/gamma.h"

#include <cmath>

namespace candelabra {

DisplayValue Contrast::shown(const Rgb& colour, double clear) const {
    DisplayValue shown{colour, clear};
    for (int i = 0; i < 3; ++i)
        shown.colour[i] = from_linear(exposure * to_linear(colour[i], assumed_gamma), gamma);
    return shown;
}

bool Contrast::between(const DisplayValue& a, const DisplayValue& b) const {
    const Rgb difference = abs(a.colour - b.colour);
    return difference.r + difference.g + difference.b + std::abs(a.clear - b.clear) >= threshold;
}

Contrast contrast_of(const RenderSettings& settings, double assumed_gamma, double exposure) {
    return {settings.antialias_threshold, assumed_gamma, settings.antialias_gamma, exposure};
}

}  // namespace candelabra
