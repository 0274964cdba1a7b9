// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/sphere.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "luminaire/emit.h"
#include "luminaire/light_proxy.h"

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Whether the sphere is sampled by its area: from a point on the surface, a cone that is (almost)
/// a half space would miss the far side of a hollow lamp.
bool inside_or_on(const SphereEmitter& s, double distance) {
    return distance <= s.radius * (1 + 1e-9);
}

/// 1 - cos of the angle between the centre and the rim of the sphere; exact also if tiny.
double rim(const SphereEmitter& s, double distance) {
    const double sine = s.radius / distance;
    return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

double area_density(const SphereEmitter& s, double distance, double cosine) {
    return distance * distance / (emitting_area(s) * cosine);
}

std::optional<LightPoint> sample_area(const SphereEmitter& s, const Vec3& from, const Vec2& u) {
    const double across = 2 * std::sqrt(u.x * (1 - u.x)), angle = 2 * pi * u.y;
    const Vec3 normal(across * on_circle(angle), 1 - 2 * u.x);
    const Vec3 position = s.centre + s.radius * normal, offset = position - from;
    const double distance = length(offset);
    const double cosine = std::abs(dot(normal, offset)) / distance;
    if (!(distance > 0 && cosine > 0)) return {};
    return LightPoint{position, offset / distance, distance, area_density(s, distance, cosine)};
}

/// The sphere as seen from a point outside.
struct SphereView {
    Vec3 middle;  ///< unit
    double distance, sine2;

    SphereView(const SphereEmitter& s, const Vec3& from) : middle(s.centre - from) {
        distance = length(middle);
        middle /= distance;
        sine2 = (s.radius / distance) * (s.radius / distance);
    }
};

/// Returns the point of the sphere in a direction that makes an angle of this cosine with the
/// middle; `across` is the direction's part perpendicular to the middle. The nearer intersection
/// and the position are computed in forms that lose no digits close to the sphere or far from it.
LightPoint point_towards(const SphereEmitter& s, const SphereView& view, double cosine,
                         const Vec3& across, double density) {
    const double d = view.distance, across2 = dot(across, across);
    const double half_chord = std::sqrt(std::fmax(0, s.radius * s.radius - d * d * across2));
    const double distance = (d - s.radius) * (d + s.radius) / (d * cosine + half_chord);
    const double along = -(d * across2 + cosine * half_chord);
    const Vec3 position = s.centre + s.radius * unit(along * view.middle + distance * across);
    return {position, cosine * view.middle + across, distance, density};
}

LightPoint sample_cone(const SphereEmitter& s, const SphereView& view, const Vec2& u) {
    const double widest = rim(s, view.distance), versine = u.x * widest, cosine = 1 - versine;
    const double sine = std::sqrt(versine * (2 - versine));
    const auto [x, y] = perpendiculars(view.middle);
    const Vec3 across = sine * on_circle(2 * pi * u.y, x, y);
    return point_towards(s, view, cosine, across, 1 / (2 * pi * widest));
}

/// Cosine between the normal and the sphere's centre if the whole sphere is above the horizon;
/// negative if it is wholly below, on surfaces lit from behind; else 0.
double clear_height(const SphereView& view, const Receiver& point) {
    // At the horizon itself the density loses its digits.
    constexpr double margin = 1.0001;
    const double height = dot(view.middle, point.normal);
    const bool clear = height * height > margin * view.sine2 &&
                       (height > 0 || point.horizon == Horizon::both_sides);
    return clear ? height : 0;
}

/// Density per steradian and unit of cosine: the projection of the sphere's cap of directions onto
/// the tangent plane is an ellipse in the unit disc (Nusselt analog), sampled uniformly.
double projected_density(const SphereView& view, double height) {
    return 1 / (pi * view.sine2 * std::abs(height));
}

LightPoint sample_projected(const SphereEmitter& s, const SphereView& view, const Receiver& point,
                            double height, const Vec2& u) {
    const Vec3 normal = height > 0 ? point.normal : -point.normal;
    const double sine = std::sqrt(view.sine2), up = std::abs(height);
    const Vec3 level = view.middle - up * normal;
    const Vec3 outward = dot(level, level) > 1e-20 ? unit(level) : perpendiculars(normal).first;
    const Vec3 sideways = cross(normal, outward);
    const double radius = sine * std::sqrt(u.x);
    const auto [side, ahead] = math::sin_cos(2 * pi * u.y);
    const double along = radius * ahead, beside = radius * side;
    // The ellipse's centre is the cap's centre times the cosine of the cap's half angle. The point
    // of the ellipse is then projected up to the sphere of directions.
    const double cosine_rim = std::sqrt(1 - view.sine2);
    const double a = cosine_rim * length(level) + up * along;
    const double lifted = std::sqrt(std::fmax(0, 1 - a * a - beside * beside));
    const Vec3 direction = a * outward + beside * sideways + lifted * normal;
    const Vec3 turn = cross(view.middle, direction);
    const Vec3 across = cross(turn, view.middle);
    return point_towards(s, view, dot(view.middle, direction), across,
                         lifted * projected_density(view, height));
}

}  // namespace

LightBounds bounds(const SphereEmitter& s, double luminance) {
    return {Box{s.centre - s.radius, s.centre + s.radius}, s.centre, s.radius, Vec3(0),
            luminance * pi * s.radius * s.radius,          luminance};
}

double unoccluded(const SphereEmitter& s, double luminance, const Receiver& point) {
    return irradiance(light_proxy(bounds(s, luminance)), point);
}

std::optional<LightPoint> sample(const SphereEmitter& s, const Vec3& from, const Vec2& u) {
    const double to_centre = length(s.centre - from);
    if (inside_or_on(s, to_centre)) return sample_area(s, from, u);
    return sample_cone(s, SphereView(s, from), u);
}

std::optional<LightPoint> sample(const SphereEmitter& s, const Receiver& point, const Vec2& u) {
    if (inside_or_on(s, length(s.centre - point.position)))
        return sample_area(s, point.position, u);
    const SphereView view(s, point.position);
    const double height = clear_height(view, point);
    if (height == 0) return sample_cone(s, view, u);
    const LightPoint drawn = sample_projected(s, view, point, height, u);
    return drawn.density > 0 ? std::optional(drawn) : std::nullopt;
}

void intersect(const SphereEmitter& s, const Receiver& point, const Vec3& direction,
               LightHits& met) {
    const Vec3 offset = s.centre - point.position;
    const double along = dot(offset, direction);
    const Vec3 beside = offset - along * direction;
    const double missed2 = dot(beside, beside);
    if (missed2 >= s.radius * s.radius) return;
    const double half_chord = std::sqrt(s.radius * s.radius - missed2);
    if (inside_or_on(s, length(offset))) {
        for (const double distance : {along - half_chord, along + half_chord})
            if (distance > 0)
                met.push_back({distance, area_density(s, distance, half_chord / s.radius)});
        return;
    }
    if (!(along > 0)) return;
    const SphereView view(s, point.position);
    const double height = clear_height(view, point);
    const double density =
        height == 0 ? 1 / (2 * pi * rim(s, view.distance))
                    : std::abs(dot(direction, point.normal)) * projected_density(view, height);
    met.push_back({along - half_chord, density});
}

std::optional<EmittedRay> emit(const SphereEmitter& s, double inner, const EmissionDraw& u) {
    const double across = 2 * std::sqrt(u.where.x * (1 - u.where.x)), angle = 2 * pi * u.where.y;
    const Vec3 normal(across * on_circle(angle), 1 - 2 * u.where.x);
    return emitted_ray(s.centre + s.radius * normal, normal, 1 / emitting_area(s), inner, u);
}

double emitting_area(const SphereEmitter& s) { return 4 * pi * s.radius * s.radius; }

}  // namespace candelabra
