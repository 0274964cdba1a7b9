// SPDX-License-Identifier: GPL-3.0-or-later
// Transmittance of surfaces and media between a light and a point, followed from the point.
#pragma once

#include "base/random.h"
#include "world/world.h"

#include <span>

namespace candelabra {

/// A straight line to a light.
struct WayOfLight {
    Ray ray;               ///< its direction is a unit vector
    double tolerance = 0;  ///< see World::transmittance()
    double distance = 0;   ///< of the light, which may be very far away
    std::span<const PrimitiveIndex> around = {};
    double apart = 0;
    /// Whether media outside of solids attenuate the light: as in POV-Ray, also within solids.
    bool in_atmosphere = true;
};

/// Transmittance per channel; an unbiased estimate for inhomogeneous media, otherwise exact.
Vec3 light_left(const World&, const WayOfLight&, const Key&);

/// Depth of media with nothing behind them, as in POV-Ray.
constexpr double end_of_air = 2e10;

using MediaList = ShortList<const Media*, 4>;
inline MediaView view_of(const MediaList& list) { return {list.data(), list.size()}; }

/// Adds the media in nested solids: none if one of the solids is not hollow.
void add_media(const World&, std::span<const PrimitiveIndex> solids, MediaList&);
/// Adds the media outside of solids.
void add_atmosphere(const World&, MediaList&);

}  // namespace candelabra
