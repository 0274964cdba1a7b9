// SPDX-License-Identifier: GPL-3.0-or-later
// Transmittance of surfaces and media between a light and a point, followed from the point.
#pragma once

#include "base/random.h"
#include "base/rgb.h"
#include "world/world.h"

#include <cstdint>
#include <span>

namespace candelabra {

/// What dims light between surfaces.
enum class AirOnWay : std::uint8_t {
    /// What dims a ray that is followed: between two surfaces media of the solids around, if all of
    /// these are hollow, and then fog, rainbows and media outside of solids, too.
    followed,
    /// Media in solids, and on the whole way media and fog outside of solids: as in POV-Ray, also
    /// within solids.
    throughout,
    in_solids,  ///< only media in solids
    none
};

/// Distance of light from behind everything.
inline constexpr double far_away = 1e20;

/// A straight line to a light.
struct WayOfLight {
    Ray ray;               ///< its direction is a unit vector
    double tolerance = 0;  ///< see World::transmittance()
    double distance = 0;   ///< of the light, which may be very far away
    bool ends = true;      ///< at a surface or a point; false: nothing is met, as towards the sky
    std::span<const PrimitiveIndex> around = {};
    double apart = 0;
    AirOnWay air = AirOnWay::followed;
};

/// Transmittance of surfaces and air per channel; an unbiased estimate for inhomogeneous media,
/// otherwise exact.
Rgb light_left(const World&, const WayOfLight&, const Key&);
/// The same if it is known that no surface lies on the way.
Rgb left_on_free_way(const World&, const WayOfLight&, const Key&);

/// Fraction of the light of a luminaire or of media that its own solid lets through on its way to
/// the ray's origin, if the solid has `no_shadow`: other light passes it, and light_left() leaves
/// it out. 1 for other solids.
Rgb left_by_lamp(const World&, const Luminaire&, const WayOfLight&, const Key&);
/// The same of media, times left_by_fog_behind().
Rgb left_by_lamp(const World&, const MediaBox&, const WayOfLight&, const Key&);

/// Fraction that fog leaves of the light of media at a distance on a ray, by the fog behind them up
/// to the next surface: as in POV-Ray, fog covers all media between two surfaces.
Rgb left_by_fog_behind(const World&, const Ray&, double distance, const Key&);

/// A part of a ray between two surfaces, inside of the solids.
struct AirStretch {
    const Ray& ray;
    Interval part;
    std::span<const PrimitiveIndex> solids;
    bool ends = true;  ///< the ray meets a surface after it
};
/// Transmittance of all that dims a ray which is followed (see AirOnWay::followed), as above.
Rgb left_in_air(const World&, const AirStretch&, const Key&);

/// Depth of media with nothing behind them, as in POV-Ray.
constexpr double end_of_air = 2e10;

using MediaList = ShortList<const Media*, 4>;
inline MediaView view_of(const MediaList& list) { return {list.data(), list.size()}; }

/// Adds the media in nested solids: none if one of the solids is not hollow.
void add_media(const World&, std::span<const PrimitiveIndex> solids, MediaList&);
/// Adds the media outside of solids.
void add_atmosphere(const World&, MediaList&);
/// Adds the media that a followed ray meets inside of the solids. As in POV-Ray, media in solids do
/// not show on a ray that meets no surface any more.
void add_followed(const World&, std::span<const PrimitiveIndex> solids, bool ends, MediaList&);

}  // namespace candelabra
