// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray sees that meets no surface.
#include "world/world.h"

#include <algorithm>

namespace candelabra {

Vec3 World::sky_radiance(const Vec3& direction, const Vec3& behind) const {
    const Vec3 farthest = sky.daylight ? sky.daylight->radiance(direction) : behind;
    if (!sky.sphere) return farthest;
    return radiance(*sky.sphere, direction, farthest, pattern_scene(),
                    rules.language_version < 3.7);
}

Vec3 World::sun_radiance(const Vec3& direction) const {
    const Vec3 seen = sky.daylight ? sky.daylight->disc(direction) : Vec3(0);
    if (seen == Vec3(0) || !sky.sphere) return seen;
    const auto clouded = [&](const Vec3& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(),
                        rules.language_version < 3.7);
    };
    return clouded(seen) - clouded(Vec3(0));
}

double World::sky_clear(const Vec3& direction) const {
    if (sky.daylight) return 0;
    if (rules.language_version < 3.7) return 1;
    const double clear = std::clamp(grey(sky.background.colour.passing()), 0.0, 1.0);
    if (!sky.sphere) return clear;
    const auto seen = [&](const Vec3& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(), false);
    };
    return std::min(1.0, clear * std::abs(grey(seen(Vec3(1)) - seen(Vec3(0)))));
}

}  // namespace candelabra
