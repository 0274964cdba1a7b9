// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex from photons. Called by the direct light.
#pragma once

#include "transport/light_ledger.h"
#include "transport/photons.h"

namespace candelabra {

struct LitLayer;

/// Each job has its own.
class PhotonLight : public ServedGeneration<Photons> {
public:
    using ServedGeneration::ServedGeneration;

    /// Radiance towards the viewer, from the generation that serves the sample. Precondition: there
    /// are photons, and the layer is that of a surface. `through_surface`: see BsdfTerms, for
    /// photons of light sources.
    Vec3 operator()(const LitLayer&, const Key&, LightLedger&, bool through_surface);
};

}  // namespace candelabra
