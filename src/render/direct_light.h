// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a point: POV-Ray's light sources one by one, luminaires as the light sampler
// chooses.
#pragma once

#include "base/random.h"
#include "render/shade.h"
#include "render/statistics.h"

/// Radiance towards the viewer by light that comes straight from lights and luminaires; an unbiased
/// estimate.
class DirectLight {
public:
    DirectLight(const World& world, int shadow_rays) : world_(world), shadow_rays_(shadow_rays) {}

    Vec3 operator()(const Shading&, const Key&, RayCounts&);

private:
    Vec3 from_sources(const Shading&, const Key&, RayCounts&) const;
    Vec3 from_luminaires(const Shading&, const Key&, RayCounts&);
    Vec3 from_luminaire(const Shading&, const LightPick&, const Key&, RayCounts&) const;

    const World& world_;
    int shadow_rays_;
    LightPicks picks_;  // kept from hit to hit for its memory
};
