// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/sphere.h"

#include "luminaire/glow.h"

#include <numbers>

namespace {

using std::numbers::pi;

/// From here on inwards the sphere is sampled by its area: a cone that is (almost) a half space
/// would miss the far side, which is what a point on the surface sees of a hollow lamp.
bool inside_or_on(const SphereEmitter& s, double distance) {
    return distance <= s.radius * (1 + 1e-9);
}

/// 1 - cos of the angle between the middle and the rim of the sphere; exact also when it is tiny.
double rim(const SphereEmitter& s, double distance) {
    const double sine = s.radius / distance;
    return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

double area_density(const SphereEmitter& s, double distance, double cosine) {
    return distance * distance / (emitting_area(s) * cosine);
}

std::optional<LightPoint> sample_area(const SphereEmitter& s, const Vec3& from, const Vec2& u) {
    const double across = 2 * std::sqrt(u.x * (1 - u.x)), angle = 2 * pi * u.y;
    const Vec3 normal(across * std::cos(angle), across * std::sin(angle), 1 - 2 * u.x);
    const Vec3 position = s.centre + s.radius * normal, offset = position - from;
    const double distance = length(offset);
    const double cosine = std::abs(dot(normal, offset)) / distance;
    if (!(distance > 0 && cosine > 0)) return {};
    return LightPoint{position, offset / distance, distance, area_density(s, distance, cosine)};
}

std::optional<LightPoint> sample_cone(const SphereEmitter& s, const Vec3& from, double to_centre,
                                      const Vec2& u) {
    const double widest = rim(s, to_centre), versine = u.x * widest, cosine = 1 - versine;
    const double sine2 = versine * (2 - versine), sine = std::sqrt(sine2);
    const Vec3 middle = (s.centre - from) / to_centre;
    const auto [x, y] = perpendiculars(middle);
    const double angle = 2 * pi * u.y;
    const Vec3 across = std::cos(angle) * x + std::sin(angle) * y;
    const Vec3 direction = cosine * middle + sine * across;
    const double half_chord =
        std::sqrt(std::fmax(0, s.radius * s.radius - to_centre * to_centre * sine2));
    // Near root and place on the sphere in forms that lose no digits, neither close to the sphere
    // nor far from it.
    const double distance =
        (to_centre - s.radius) * (to_centre + s.radius) / (to_centre * cosine + half_chord);
    const double along = -(to_centre * sine2 + cosine * half_chord);
    const Vec3 position = s.centre + s.radius * unit(along * middle + distance * sine * across);
    return LightPoint{position, direction, distance, 1 / (2 * pi * widest)};
}

}  // namespace

LightBounds bounds(const SphereEmitter& s, double luminance) {
    return {Box{s.centre - s.radius, s.centre + s.radius}, s.centre, s.radius, Vec3(0),
            luminance * pi * s.radius * s.radius,          luminance};
}

double unoccluded(const SphereEmitter& s, double luminance, const ShadingPoint& point) {
    return irradiance(glow(bounds(s, luminance)), point);
}

std::optional<LightPoint> sample(const SphereEmitter& s, const Vec3& from, const Vec2& u) {
    const double to_centre = length(s.centre - from);
    return inside_or_on(s, to_centre) ? sample_area(s, from, u)
                                      : sample_cone(s, from, to_centre, u);
}

double density(const SphereEmitter& s, const Vec3& from, const Vec3& direction) {
    const Vec3 offset = s.centre - from;
    const double to_centre = length(offset), along = dot(offset, direction);
    const double missed = length(offset - along * direction);
    if (!inside_or_on(s, to_centre))
        return along > 0 && missed < s.radius ? 1 / (2 * pi * rim(s, to_centre)) : 0;
    const double half_chord = std::sqrt(std::fmax(0, (s.radius - missed) * (s.radius + missed)));
    if (half_chord == 0) return 0;
    double sum = 0;
    for (const double distance : {along - half_chord, along + half_chord})
        if (distance > 0) sum += area_density(s, distance, half_chord / s.radius);
    return sum;
}

double emitting_area(const SphereEmitter& s) { return 4 * pi * s.radius * s.radius; }
