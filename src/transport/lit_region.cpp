// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lit_region.h"

#include "base/circle.h"
#include "base/cosine_direction.h"
#include "base/order.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Number of camera rays in each direction that find the region.
constexpr std::uint32_t rays_across = 16;
/// Fraction of the places met that the region holds.
constexpr double held = 0.9;
/// Minimum distance of far starts, in radii of the region.
constexpr double far_start = 1e5;

/// Returns the number below which that fraction of the numbers lies. Precondition: there are some.
double quantile(std::vector<double> all, double fraction) {
    const auto place =
        all.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(all.size() - 1));
    put_nth(all.begin(), place, all.end());
    return *place;
}

}  // namespace

bool sees(const World& world, const SeenPlace& place, const Vec3& position, const Vec3& normal,
          double tolerance) {
    const Vec3 offset = position - place.position;
    const double away = length(offset);
    if (!(away > place.tolerance && dot(offset, place.normal) > 0 && dot(offset, normal) < 0))
        return false;
    Hit hit;
    return !world.first_hit({place.position, offset / away}, place.tolerance, RayKind::gathering,
                            hit) ||
           length(hit.position - place.position) > away - tolerance;
}

std::vector<SeenPlace> seen_places(const Shot& shot) {
    const World& world = *shot.world;
    std::vector<SeenPlace> met;
    for (std::uint32_t i = 0; i < rays_across * rays_across; ++i) {
        const auto across = [](std::uint32_t n) { return (n + 0.5) / rays_across - 0.5; };
        Ray ray = shot.view.camera.ray(across(i % rays_across), across(i / rays_across));
        if (ray.direction == Vec3(0)) continue;
        double tolerance = 0;
        for (const RayKind kind : {RayKind::camera, RayKind::gathering}) {
            Hit hit;
            if (!world.first_hit(ray, tolerance, kind, hit)) break;
            Vec3 normal = unit(hit.normal);
            if (dot(normal, ray.direction) > 0) normal = -normal;
            met.push_back({hit.position, normal, hit.tolerance});
            const Key key{0, i, 0, 0};
            ray = {hit.position, cosine_direction(normal, {uniform(key, Purpose::bounce_u),
                                                           uniform(key, Purpose::bounce_v)})};
            tolerance = hit.tolerance;
        }
    }
    return met;
}

LitRegion LitRegion::of(const Shot& shot, const std::vector<SeenPlace>& met) {
    LitRegion region{shot.view.camera.location};
    if (!met.empty()) {
        std::vector<double> all(met.size());
        for (int axis = 0; axis < 3; ++axis) {
            std::ranges::transform(met, all.begin(),
                                   [&](const SeenPlace& each) { return each.position[axis]; });
            region.centre[axis] = quantile(all, 0.5);
        }
        std::ranges::transform(met, all.begin(), [&](const SeenPlace& each) {
            return length(each.position - region.centre);
        });
        const double away = quantile(all, held);
        if (away > 0 && std::isfinite(away)) region.radius = away;
    }
    region.upstream = far_start * region.radius;
    const Geometry& geometry = shot.world->geometry;
    Box box;
    for (std::uint32_t item = 0; item < geometry.item_count(); ++item)
        box = join(box, geometry.finite_bounds(item));
    if (!box.empty())
        region.upstream =
            std::fmax(region.upstream, length(box.centre() - region.centre) + length(box.size()));
    return region;
}

double LitRegion::greatest_cosine(const Vec3& from, const Vec3& normal) const {
    const Vec3 offset = centre - from;
    const double away = length(offset);
    if (!(away > radius)) return 1;
    // The angle to the middle, less that between the middle and the edge of the ball.
    const double wide = radius / away, narrow = std::sqrt(1 - wide * wide),
                 cosine = std::clamp(dot(offset, normal) / away, -1.0, 1.0);
    if (cosine > narrow) return 1;
    return std::fmax(cosine * narrow + std::sqrt(1 - cosine * cosine) * wide, 0);
}

Vec3 point_in_disc(const Vec3& axis, double radius, const Vec2& u) {
    const auto [x, y] = perpendiculars(axis);
    const double away = radius * std::sqrt(u.x), angle = 2 * pi * u.y;
    return away * on_circle(angle, x, y);
}

Vec3 point_about_disc(const Vec3& axis, double radius, const Vec2& u, double beside) {
    const double inside = 1 - beside;
    if (u.x < inside) return point_in_disc(axis, radius, {u.x / inside, u.y});
    const auto [x, y] = perpendiculars(axis);
    // The density falls with the cube of the distance.
    const double away = radius / (1 - (u.x - inside) / beside);
    return away * on_circle(2 * pi * u.y, x, y);
}

double area_about_disc(double away, double radius, double beside) {
    return away < radius ? pi * radius * radius / (1 - beside)
                         : 2 * pi * away * away * away / (beside * radius);
}

}  // namespace candelabra
