// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/source.h"

#include "luminaire/glow.h"

LightBounds bounds(const SourceEmitter& source, double luminance) {
    LightBounds result;
    result.box = {source.centre - source.radius, source.centre + source.radius};
    result.centre = source.centre;
    result.radius = source.radius;
    // Light of colour 1 is a perpendicular irradiance of pi.
    result.intensity = std::numbers::pi * luminance;
    result.luminance = luminance;
    return result;
}

double unoccluded(const SourceEmitter& source, double luminance, const Receiver& point) {
    const Glow g = glow(bounds(source, luminance));
    return irradiance(g, point) *
           against_square_law(source.falloff, source.centre - point.position, g.radius);
}

std::optional<LightPoint> sample(const SourceEmitter& source, const Vec3& from, const Vec2&) {
    const Vec3 offset = source.centre - from;
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    return LightPoint{source.centre, offset / distance, distance, 1};
}

void meet(const SourceEmitter&, const Receiver&, const Vec3&, LightMeetings&) {}

double emitting_area(const SourceEmitter&) { return 0; }
