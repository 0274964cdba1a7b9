// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces and media leave of light on its way from a light to a point, which is followed
// from the point.
#pragma once

#include "base/random.h"
#include "world/world.h"

#include <span>

namespace candelabra {

/// A straight way to a light.
struct WayOfLight {
    Ray ray;               ///< its direction is a unit vector
    double tolerance = 0;  ///< see World::transmittance()
    double distance = 0;   ///< of the light, which may be very far
    std::span<const PrimitiveIndex> around = {};
    double apart = 0;
    /// Media outside of solids count: as in POV-Ray all the way, in solids, too.
    bool in_atmosphere = true;
};

/// Per channel; an unbiased estimate where media are not the same everywhere, else exact.
Vec3 light_left(const World&, const WayOfLight&, const Key&);

/// As in POV-Ray, the end of all that is: air that nothing is behind is so deep.
constexpr double end_of_air = 2e10;

using MediaList = ShortList<const Media*, 4>;
inline MediaView view_of(const MediaList& list) { return {list.data(), list.size()}; }

/// The media in solids that are inside of each other: none where one of them is not hollow.
void add_media(const World&, std::span<const PrimitiveIndex> solids, MediaList&);
/// The media outside of solids.
void add_atmosphere(const World&, MediaList&);

}  // namespace candelabra
