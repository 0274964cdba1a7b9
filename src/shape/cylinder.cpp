// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/cylinder.h"

#include "base/infinity.h"
#include "vocabulary/schema.h"

#include "shape/cone.h"
#include "shape/slab_interval.h"

namespace candelabra {

const ItemInfo Cylinder::vocabulary = described<Cylinder>([] {
    using F = Field<Cylinder>;
    return schema<Cylinder>("cylinder",
                            {"A cylinder with flat ends.", "cylinder { 0, 1.7*y, 0.8 }",
                             "cylinder { <-1, 0.8, 0>, <1, 0.8, 0>, 0.8 open }"},
                            F{"base", &Cylinder::base, positional, "centre of one end"},
                            F{"cap", &Cylinder::cap, positional, "centre of the other end"},
                            F{"radius", &Cylinder::radius, positional, "radius", any_sign()},
                            F{"open", &Cylinder::open, flag, "leaves the ends out"});
});

Box bounds(const Cylinder& c) { return bounds(Cone{c.base, c.radius, c.cap, c.radius, c.open}); }

void crossings(const Cylinder& cylinder, const Ray& ray, Crossings& found) {
    // Computed from the point of the ray nearest to the middle, so that a distant origin loses no
    // digits.
    const Vec3& direction = ray.direction;
    const double radius2 = cylinder.radius * cylinder.radius, speed2 = dot(direction, direction);
    const Vec3 middle = 0.5 * (cylinder.base + cylinder.cap), half = cylinder.cap - middle;
    const double start = dot(middle - ray.origin, direction) / speed2;
    const Vec3 near = ray.at(start), off = near - middle;
    if (!(dot(off, off) <= (radius2 + dot(half, half)) * (1 + 1e-9))) return;

    // Position along the axis, in units of its length, and offset from it: each at t = 0 and per t.
    const Vec3 axis = cylinder.cap - cylinder.base, from = near - cylinder.base;
    const double per_length2 = 1 / dot(axis, axis);
    const double height = dot(from, axis) * per_length2, rise = dot(direction, axis) * per_length2;
    const Vec3 away = from - height * axis, step = direction - rise * axis;
    const Interval ends = between_ends(height, 1 - height, rise);
    // Interval around the deepest point of the ray.
    const double step2 = dot(step, step);
    Interval side{-infinity, infinity};
    if (step2 > 1e-30 * speed2) {
        const double deepest = -dot(away, step) / step2;
        const Vec3 least = away + deepest * step;
        const double reach2 = (radius2 - dot(least, least)) / step2;
        if (!(reach2 > 0)) return;
        side = {deepest - std::sqrt(reach2), deepest + std::sqrt(reach2)};
    } else if (!(dot(away, away) < radius2)) {
        return;
    }
    const bool first_at_end = ends.min >= side.min, last_at_end = ends.max <= side.max;
    const double first = first_at_end ? ends.min : side.min,
                 last = last_at_end ? ends.max : side.max;
    if (!(first < last)) return;
    const Vec3 up = first_at_end || last_at_end ? unit(axis) : axis;
    const auto met = [&](double t, bool at_end, bool entering) -> Crossing {
        if (!at_end) return {start + t, unit(away + t * step), entering};
        const bool at_base = entering == (rise > 0);
        const Vec3& end = at_base ? cylinder.base : cylinder.cap;
        return {meeting_with_end(ray, end, up, start + t), at_base ? -up : up, entering};
    };
    // A ray that does not pass through the side only touches it.
    const auto passes = [&](double t, bool at_end, bool entering) {
        const double along = dot(step, away + t * step);
        return at_end || (entering ? along < 0 : along > 0);
    };
    if (!passes(first, first_at_end, true) || !passes(last, last_at_end, false)) return;
    const Crossing in = met(first, first_at_end, true), out = met(last, last_at_end, false);
    if (!(in.t < out.t)) return;
    if (!(cylinder.open && first_at_end)) found.add(in);
    if (!(cylinder.open && last_at_end)) found.add(out);
}

bool inside(const Cylinder& cylinder, const Vec3& point) {
    const Vec3 axis = cylinder.cap - cylinder.base, from = point - cylinder.base;
    const double height = dot(from, axis) / dot(axis, axis);
    const Vec3 away = from - height * axis;
    const double distance2 = dot(away, away), radius2 = cylinder.radius * cylinder.radius;
    // As in POV-Ray 3.7, the surface belongs to the inside only when the ends are open.
    if (cylinder.open) return height >= 0 && height <= 1 && distance2 <= radius2;
    return height > 0 && height < 1 && distance2 < radius2;
}

std::string problem(const Cylinder& cylinder) {
    return length(cylinder.cap - cylinder.base) > 0 ? ""
                                                    : "a `cylinder` needs two different end points";
}

std::string vanishes(const Cylinder& cylinder) {
    return cylinder.radius == 0 ? "its radius is 0" : "";
}

}  // namespace candelabra
