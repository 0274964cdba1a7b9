// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that come from a sky which is a luminaire: the beginnings of paths of its light.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/ray.h"
#include "transport/lit_region.h"
#include "transport/start_guide.h"

namespace candelabra {

class SkyRays {
public:
    /// The world must outlive this.
    SkyRays(const World&, const LitRegion&);

    /// About the light that the sky sends into the region: colour of light times area, as
    /// luminance. 0: the sky is no luminaire, or black.
    double power() const { return power_; }

    struct Drawn {
        Ray ray;     ///< it starts before all finite things
        Rgb power;   ///< colour of light times the area, perpendicular to it, for which it stands
    };
    /// The mean over many rays is all light of the sky. Precondition: power() is above 0.
    Drawn draw(const Key&) const;

    /// Finds which starts are worth most, by trials. `worth` returns what a path with that start is
    /// worth. Precondition: power() is above 0.
    void learn(FunctionRef<double(const Drawn&, const Key&)> worth);

private:
    Drawn from(const Vec2& direction, const Vec2& aside) const;

    const World& world_;
    LitRegion region_;
    double power_ = 0;
    StartGuide directions_, places_;
};

}  // namespace candelabra
