// SPDX-License-Identifier: GPL-3.0-or-later
// Light of photons in media, as seen along a ray. Called by ParticipatingMedia.
#pragma once

#include "base/rgb.h"
#include "medium/media.h"
#include "transport/air_photons.h"
#include "transport/light_ledger.h"
#include "transport/path.h"

namespace candelabra {

/// A segment of a path through media.
struct PhotonStretch {
    const PathState& path;
    double distance;  ///< from the ray's origin
    MediaView media;
    int choices = 8;  ///< photons evaluated in inhomogeneous media; more in others
};

/// Radiance along the path's ray; an unbiased estimate, except for the blur of the photons' balls.
Rgb light_of_air_photons(const World&, const AirPhotonMap&, const PhotonStretch&, LightLedger&);

}  // namespace candelabra
