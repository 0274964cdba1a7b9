// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a layer of a surface from photons. Called by DirectLight.
#pragma once

#include "base/rgb.h"
#include "transport/arrival.h"
#include "transport/photon_map.h"

namespace candelabra {

/// Radiance towards the viewer. Precondition: the layer is that of a surface.
Rgb light_of_photons(const PhotonMap&, const ArrivingLight&, const Key&);

}  // namespace candelabra
