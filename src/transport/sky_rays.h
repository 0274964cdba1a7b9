// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that come from a sky which is a luminaire: the beginnings of paths of its light.
#pragma once

#include "base/random.h"
#include "base/ray.h"
#include "transport/lit_region.h"
#include "transport/sky_starts.h"

#include <array>
#include <span>

namespace candelabra {

class SkyRays {
public:
    /// The world must outlive this. Rays lead mostly to what lights the seen places.
    SkyRays(const World&, const LitRegion&, std::span<const SeenPlace>);

    /// About the light that the sky sends into the region: colour of light times area, as
    /// luminance. 0: the sky is no luminaire, or black.
    double power() const { return power_; }

    struct Drawn {
        Ray ray;     ///< it starts before all finite things
        Rgb power;   ///< colour of light times the area, perpendicular to it, for which it stands
    };
    /// The mean over many rays is all light of the sky. `choice` is in [0, 1). Precondition:
    /// power() is above 0.
    Drawn draw(double choice, const Key&) const;

private:
    const World& world_;
    LitRegion region_;
    double power_ = 0;
    std::array<SkyGuide, 2> guides_;  ///< the wider one first; both may be empty
};

}  // namespace candelabra
