// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/use.h"

namespace candelabra {

Vec3 PatternUse::place(const Vec3& point) const {
    const Vec3 p = holes ? holes->warped(steps, point) : warped(steps, point);
    if (modifiers.turbulence == Vec3(0) || !displaced(pattern)) return p;
    return within_reach(p + modifiers.turbulence * turbulence(p, modifiers.noise_octaves()));
}

double PatternUse::value(const Vec3& place, const PatternScene& scene) const {
    return waved(wave, modifiers, evaluate(pattern, {place, modifiers, scene}));
}

Nesting nesting(const PatternUse& use) {
    Nesting result{1, 0};
    result.by_view = std::holds_alternative<Aoi>(use.pattern);
    result.by_surface = result.by_view || std::holds_alternative<Slope>(use.pattern);
    if (const auto* bumps = std::get_if<BumpMap>(&use.pattern))
        result.by_axes = bumps->tangent_space;
    if (const auto* grey = std::get_if<PigmentGrey>(&use.pattern)) result.add(grey->nesting);
    return result;
}

}  // namespace candelabra
