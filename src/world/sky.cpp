// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray sees that meets no surface.
#include "world/world.h"

#include <algorithm>

namespace candelabra {

Vec3 World::sky_radiance(const Vec3& direction, const Vec3& behind) const {
    if (!sky.sphere) return behind;
    return radiance(*sky.sphere, direction, behind, pattern_scene(), rules.language_version < 3.7);
}

double World::sky_clear(const Vec3& direction) const {
    if (rules.language_version < 3.7) return 1;
    const double clear = std::clamp(grey(sky.background.colour.passing()), 0.0, 1.0);
    if (!sky.sphere) return clear;
    const auto seen = [&](const Vec3& behind) {
        return radiance(*sky.sphere, direction, behind, pattern_scene(), false);
    };
    return std::min(1.0, clear * std::abs(grey(seen(Vec3(1)) - seen(Vec3(0)))));
}

}  // namespace candelabra
