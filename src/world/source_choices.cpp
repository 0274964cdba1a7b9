// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/source_choices.h"

#include <numbers>

namespace candelabra {

namespace {

/// Fraction of the distance to a source within which a surface hides it.
constexpr double before_source = 1 - 1e-9;

}  // namespace

LightBounds SourceChoices::bounds(LightIndex light) const {
    const ChoosableSource& source = sources_[light];
    LightBounds result;
    result.box = {source.centre - source.radius, source.centre + source.radius};
    result.centre = source.centre;
    result.radius = source.radius;
    // Light of colour 1 has a perpendicular irradiance of pi.
    result.intensity = std::numbers::pi * source.luminance;
    result.luminance = source.luminance;
    return result;
}

double SourceChoices::unoccluded(LightIndex light, const Receiver& point) const {
    const LightProxy g = light_proxy(bounds(light));
    return irradiance(g, point) *
           against_square_law(sources_[light].falloff, g.centre - point.position, g.radius);
}

double SourceChoices::arriving(LightIndex light, const SurveyPlace& from, const Vec2&,
                               const LightProbe& probe) const {
    const Vec3 offset = sources_[light].centre - from.point.position;
    const double distance = length(offset);
    if (!(distance > 0)) return 0;
    double left = 0;
    const Ray ray{from.point.position, offset / distance};
    const double behind =
        look_along(ray, from.tolerance, probe, [&](const ProbeHit& sight, double share) {
            if (sight.distance < distance * before_source) return false;
            left = share;
            return true;
        });
    return (left + behind) * unoccluded(light, from.point);
}

}  // namespace candelabra
