// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray sees that meets no surface.
#include "world/world.h"

#include <algorithm>

namespace candelabra {

Rgb World::sky_radiance(const Vec3& direction, const Rgb& behind) const {
    const Rgb farthest = sky.daylight ? sky.daylight->radiance(direction) : behind;
    if (!sky.sphere) return farthest;
    return radiance(*sky.sphere, direction, farthest, pattern_scene(),
                    rules.language_version < 3.7);
}

Rgb World::sun_radiance(const Vec3& direction) const {
    const Rgb seen = sky.daylight ? sky.daylight->disc(direction) : Rgb(0);
    if (seen == Rgb(0) || !sky.sphere) return seen;
    const auto clouded = [&](const Rgb& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(),
                        rules.language_version < 3.7);
    };
    return clouded(seen) - clouded(Rgb(0));
}

double World::sky_clear(const Vec3& direction) const {
    if (sky.daylight) return 0;
    if (rules.language_version < 3.7) return 1;
    const double clear = std::clamp(grey(sky.background.colour.passing()), 0.0, 1.0);
    if (!sky.sphere) return clear;
    const auto seen = [&](const Rgb& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(), false);
    };
    return std::min(1.0, clear * std::abs(grey(seen(Rgb(1)) - seen(Rgb(0)))));
}

}  // namespace candelabra
