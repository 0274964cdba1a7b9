// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/radiance.h"

#include "world/volumes.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

Rgb greatest_emission(const Material& material) {
    const Rgb outer = greatest_emission(*material.texture);
    return material.inner ? max(outer, greatest_emission(*material.inner)) : outer;
}

Rgb radiance_of(const World& world, const Luminaire& luminaire, const EmittingPoint& point) {
    const bool same_everywhere = !luminaire.varying && !luminaire.two_faced && !luminaire.web;
    if (same_everywhere) return luminaire.radiance;
    const SeenPoint& seen = point.seen;
    return world.material(luminaire.primitive).by_surface
               ? world.emission(seen, point.direction)
               : world.emission(luminaire.primitive, seen.point, seen.side, &point.direction);
}

double luminance_at(const World& world, PrimitiveIndex primitive, const Vec3& point) {
    if (world.material(primitive).by_surface)
        return luminance(greatest_emission(world.material(primitive))) *
               world.output(primitive, nullptr);
    const double outer = luminance(world.emission(primitive, point, Side::outer));
    if (!world.material(primitive).inner) return outer;
    return std::max(outer, luminance(world.emission(primitive, point, Side::inner)));
}

Rgb radiance_seen(const World& world, const MediaBox& box, const PointOnRay& point) {
    if (!world.lights.glow_beside_openings)
        return volume_emission(world, box.primitive, point.ray.at(point.distance));
    const EnteredSolids around = world.containing(point.ray.origin);
    return volume_emission(
        world, box.primitive,
        {point.ray, point.tolerance, point.distance, {around.data(), around.size()}});
}

Rgb radiance_seen(const World& world, const Luminaire& luminaire, const PointOnRay& point) {
    const Interval place = World::end_of_way(point.tolerance, point.distance);
    Rgb seen(0), left(1);
    world.along(point.ray, place.min, RayKind::light, [&](const Hit& hit, double distance) {
        if (distance > place.max) return false;
        // A luminaire may be met more than once.
        if (hit.primitive == luminaire.primitive &&
            std::abs(distance - point.distance) <= same_point * point.distance + hit.tolerance) {
            seen = left * radiance_of(world, luminaire, emitting_point(hit, point.ray));
            return false;
        }
        left *= world.passed(hit, point.ray);
        return left != Rgb(0);
    });
    return seen;
}

}  // namespace candelabra
