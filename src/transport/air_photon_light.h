// SPDX-License-Identifier: GPL-3.0-or-later
// Light that photons have brought to media, as a ray sees it. Called where media are.
#pragma once

#include "medium/media.h"
#include "transport/air_photons.h"
#include "transport/light_ledger.h"
#include "transport/path.h"

namespace candelabra {

/// Part of a path in media.
struct AirStretch {
    const PathState& path;
    double distance;  ///< from the origin of its ray on
    MediaView media;
    int choices = 8;  ///< photons that are looked at where media differ from place to place; of
                      ///< others more are
};

/// Radiance that comes along the path's ray; below the blur of the photons' balls an unbiased
/// estimate.
Vec3 light_of_air_photons(const World&, const AirPhotonMap&, const AirStretch&, LightLedger&);

}  // namespace candelabra
