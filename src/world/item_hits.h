// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ray meets one item of a world: for the queries that ask many items.
#pragma once

#include "base/function_ref.h"
#include "base/ray.h"
#include "shape/ray_start.h"
#include "world/geometry.h"
#include "world/ray_constants.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace candelabra {

/// A surface that a ray has met.
struct MetSurface {
    double t;
    PrimitiveIndex primitive = no_primitive;
    Vec3 normal = Vec3(0);            ///< of shapes and leaves only; in the space of an instance
    std::uint32_t part = 0;           ///< of shapes and leaves only: see Crossing
    double weight2 = 0, weight3 = 0;  ///< of triangles only
};

/// See count_work().
inline constexpr std::uint32_t work_of_ray = 4;

/// Rounding errors of a hit grow with the coordinates and distances from which it is computed. This
/// fraction of them is some thousand times the error, and far below anything visible.
inline constexpr double relative_tolerance = 1e-11;
inline double tolerance_at(const Ray& ray, double t) {
    return relative_tolerance * (max_abs_component(ray.origin) + t);
}

/// Crossing in world space, with a normal of any length.
inline Crossing in_world(const PlacedShape& placed, Crossing crossing) {
    if (placed.transform) crossing.normal = placed.transform->normal(crossing.normal);
    return crossing;
}

inline Ray in_shape(const PlacedShape& placed, const Ray& ray) {
    return placed.transform ? placed.transform->inverse_ray(ray) : ray;
}

inline double size_of(const PlacedShape& placed, const Ray& ray) {
    return crossing_size(placed.box, placed.transform.get(), ray.origin);
}

/// First crossing strictly within the range at which the ray does not begin.
inline std::optional<Crossing> first_crossing(const PlacedShape& placed, const Ray& ray,
                                              Interval range) {
    const Ray own = in_shape(placed, ray);
    for (;;) {
        Crossings found;
        crossings_in(placed.shape, own, range, found);
        const Crossing* first = nullptr;
        double nearest = range.max;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double t = found[i].t;
            if (t <= range.min || t >= nearest) continue;
            nearest = t;
            first = &found[i];
        }
        if (!first) return std::nullopt;
        const Crossing met = in_world(placed, *first);
        if (!begins_on(ray, met.t, met.normal, size_of(placed, ray))) return met;
        range.min = met.t;
    }
}

/// The same for a sphere; range.max if there is none.
inline double first_crossing(const SpherePrimitive& s, const Ray& ray, const Interval& range) {
    const double t = first_crossing(s.centre, s.radius, ray, range);
    const double size = s.radius + max_abs_component(s.centre);
    if (t >= range.max || !begins_on(ray, t, ray.at(t) - s.centre, size)) return t;
    const double other = first_crossing(s.centre, s.radius, ray, {t, range.max});
    const bool begins = other < range.max && begins_on(ray, other, ray.at(other) - s.centre, size);
    return begins ? range.max : other;
}

inline bool begins_on(const Ray& ray, double t, const TrianglePrimitive& face) {
    const Vec3 normal = cross(face.corner1 - face.corner2, face.corner3 - face.corner2);
    const double size =
        std::fmax(max_abs_component(face.corner1),
                  std::fmax(max_abs_component(face.corner2), max_abs_component(face.corner3)));
    return begins_on(ray, t, normal, size);
}

/// The same as meet_item() for an instance.
void meet_instance(const Geometry&, const Instance&, const Ray&, const Interval& range,
                   MetSurface& best, FunctionRef<bool(PrimitiveIndex)> wanted);

/// Finds the nearest surface of the item within the range that is nearer than the best so far. In a
/// composite or an instance only primitives for which wanted(PrimitiveIndex) is true count.
template <class Wanted>
void meet_item(const Geometry& geometry, std::uint32_t item, RayConstants& constants,
               const Interval& range, MetSurface& best, Wanted wanted) {
    const Ray& ray = constants.ray();
    if (const Instance* placed = geometry.instance(item))
        return meet_instance(geometry, *placed, ray, range, best, wanted);
    geometry.visit(
        item,
        [&](const SpherePrimitive& s) {
            if (!wanted(item)) return;
            const double t = first_crossing(s, ray, {range.min, best.t});
            if (t < best.t) best = {t, item};
        },
        [&](const TrianglePrimitive& face) {
            if (!wanted(item)) return;
            const TriangleHit hit = constants.sheared().meet(face.corner1, face.corner2,
                                                             face.corner3, {range.min, best.t});
            if (hit.t < best.t && !begins_on(ray, hit.t, face))
                best = {hit.t, item, Vec3(0), 0, hit.weight2, hit.weight3};
        },
        [&](const PlacedShape& placed) {
            if (!wanted(item) || constants.slabs().miss(placed.box, {range.min, best.t})) return;
            const auto met = first_crossing(placed, ray, {range.min, best.t});
            if (met) best = {met->t, item, met->normal, met->part};
        },
        [&](const PlacedComposite& placed) {
            const auto own = [&](std::uint32_t leaf) { return wanted(placed.first_leaf + leaf); };
            const auto met = placed.composite->first(ray, {range.min, best.t}, own);
            if (met) best = {met->t, placed.first_leaf + met->leaf, met->normal, met->part};
        });
}

}  // namespace candelabra
