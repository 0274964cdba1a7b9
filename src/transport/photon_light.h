// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a layer of a surface from photons.
#pragma once

#include "transport/arrival.h"
#include "transport/photons.h"

namespace candelabra {

/// Each job has its own.
class PhotonLight : public ServedGeneration<Photons> {
public:
    using ServedGeneration::ServedGeneration;

    /// Radiance towards the viewer, from the generation that serves the sample. Precondition: there
    /// are photons, and the layer is that of a surface.
    Vec3 operator()(const ArrivingLight&, const Key&);
};

}  // namespace candelabra
