// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/ovus.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include "shape/sphere.h"
#include "shape/torus.h"

namespace candelabra {

const ItemInfo Ovus::vocabulary = described<Ovus>([] {
    using F = Field<Ovus>;
    return schema<Ovus>(
        "ovus", {"An egg.", "ovus { 1, 0.5 scale 0.8 translate 0.8*y }"},
        F{"bottom_radius", &Ovus::bottom_radius, positional,
          "radius of the sphere around the origin, and height of the other's centre", at_least(0)},
        F{"top_radius", &Ovus::top_radius, positional, "radius of the sphere at the top",
          at_least(0)});
});

namespace {

/// The arc of radius `radius` around <-offset, height> in the plane of the axis, tangent to both
/// circles from outside; it is part of the surface between two heights.
struct Arc {
    double radius, offset, height;
    double low, high;

    explicit Arc(const Ovus& ovus) {
        const double bottom = ovus.bottom_radius, top = ovus.top_radius;
        radius = 2 * std::fmax(bottom, top);
        // Its centre is at distance radius - bottom from one circle's centre, radius - top from the
        // other's.
        height = ((top - bottom) * (2 * radius - bottom - top) + bottom * bottom) / (2 * bottom);
        const double to_bottom = radius - bottom;
        offset = std::sqrt(std::fmax(0, (to_bottom - height) * (to_bottom + height)));
        low = height - radius * height / to_bottom;
        high = height + radius * (bottom - height) / (radius - top);
    }
};

bool only_top(const Ovus& ovus) { return ovus.top_radius >= 2 * ovus.bottom_radius; }

Sphere top(const Ovus& ovus) { return {Vec3(0, ovus.bottom_radius, 0), ovus.top_radius}; }

}  // namespace

Box bounds(const Ovus& ovus) {
    if (only_top(ovus)) return bounds(top(ovus));
    const Arc arc(ovus);
    const bool bulges = arc.low < arc.height && arc.height < arc.high;
    const double widest =
        bulges ? arc.radius - arc.offset : std::fmax(ovus.bottom_radius, ovus.top_radius);
    return {Vec3(-widest, -ovus.bottom_radius, -widest),
            Vec3(widest, ovus.bottom_radius + ovus.top_radius, widest)};
}

void crossings(const Ovus& ovus, const Ray& ray, Crossings& found) {
    if (only_top(ovus)) return crossings(top(ovus), ray, found);
    const Arc arc(ovus);
    Crossings met;
    crossings(Sphere{Vec3(0), ovus.bottom_radius}, ray, met);
    const std::size_t below = met.size();
    crossings(top(ovus), ray, met);
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double y = ray.at(met[i].t).y;
        if (i < below ? y <= arc.low : y >= arc.high) found.add(met[i]);
    }
    Crossings ring;
    const Vec3 up(0, arc.height, 0);
    crossings(Torus{arc.offset, arc.radius}, Ray{ray.origin - up, ray.direction}, ring);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec3 p = ray.at(ring[i].t) - up;
        if (!(p.y + arc.height > arc.low && p.y + arc.height < arc.high)) continue;
        // Only the inner sheet of the torus, whose tube lies beyond the axis.
        const double from_axis = math::hypot(p.x, p.z);
        const double inner = math::hypot(from_axis + arc.offset, p.y) - arc.radius;
        const double outer = math::hypot(from_axis - arc.offset, p.y) - arc.radius;
        if (std::abs(inner) < std::abs(outer)) found.add(ring[i]);
    }
}

bool inside(const Ovus& ovus, const Vec3& point) {
    if (only_top(ovus)) return inside(top(ovus), point);
    const Arc arc(ovus);
    if (point.y <= arc.low) return inside(Sphere{Vec3(0), ovus.bottom_radius}, point);
    if (point.y >= arc.high) return inside(top(ovus), point);
    return math::hypot(math::hypot(point.x, point.z) + arc.offset, point.y - arc.height) <=
           arc.radius;
}

std::string vanishes(const Ovus& ovus) {
    return ovus.bottom_radius == 0 && ovus.top_radius == 0 ? "its radii are 0" : "";
}

}  // namespace candelabra
