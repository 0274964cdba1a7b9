// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/source.h"

#include "base/circle.h"
#include "luminaire/light_proxy.h"

namespace candelabra {

LightBounds bounds(const SourceEmitter& source, double luminance) {
    LightBounds result;
    result.box = {source.centre - source.radius, source.centre + source.radius};
    result.centre = source.centre;
    result.radius = source.radius;
    // Light of colour 1 has a perpendicular irradiance of pi.
    result.intensity = std::numbers::pi * luminance;
    result.luminance = luminance;
    return result;
}

double unoccluded(const SourceEmitter& source, double luminance, const Receiver& point) {
    const LightProxy g = light_proxy(bounds(source, luminance));
    return irradiance(g, point) *
           against_square_law(source.falloff, source.centre - point.position, g.radius);
}

std::optional<LightPoint> sample(const SourceEmitter& source, const Vec3& from, const Vec2&) {
    const Vec3 offset = source.centre - from;
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    return LightPoint{source.centre, offset / distance, distance, 1};
}

void intersect(const SourceEmitter&, const Receiver&, const Vec3&, LightHits&) {}

std::optional<EmittedRay> emit(const SourceEmitter& source, double, const EmissionDraw& u) {
    const double height = 1 - 2 * u.direction.x,
                 across = std::sqrt(std::fmax(1 - height * height, 0)),
                 angle = 2 * std::numbers::pi * u.direction.y;
    const Vec3 towards(across * on_circle(angle), height);
    return EmittedRay{{source.centre, towards}, Vec3(0), 1 / (4 * std::numbers::pi), 1};
}

double emitting_area(const SourceEmitter&) { return 0; }

}  // namespace candelabra
