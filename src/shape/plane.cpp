// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/plane.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Plane::vocabulary = described<Plane>([] {
    using F = Field<Plane>;
    return schema<Plane>("plane",
                         {"An unbounded plane; its inside is the half space behind it.",
                          "plane { <0.3, 1, 0.2>, 0.5 }"},
                         F{"normal", &Plane::normal, positional,
                           "direction away from the inside, of any length but 0"},
                         F{"distance", &Plane::distance, positional,
                           "distance from the origin along the unit normal"});
});

namespace {

/// Normals that have length 1 already, as most do, are returned unchanged.
Vec3 unit_normal(const Plane& plane) {
    constexpr double rounding = 1e-15;
    const double size2 = dot(plane.normal, plane.normal);
    return std::abs(size2 - 1) < rounding ? plane.normal : unit(plane.normal);
}

}  // namespace

Box bounds(const Plane&) {
    const Vec3 everywhere(std::numeric_limits<double>::infinity());
    return {-everywhere, everywhere};
}

void crossings(const Plane& plane, const Ray& ray, Crossings& found) {
    const Vec3 normal = unit_normal(plane);
    const double approach = dot(ray.direction, normal);
    if (approach == 0) return;
    found.add({(plane.distance - dot(ray.origin, normal)) / approach, normal, approach < 0});
}

bool inside(const Plane& plane, const Vec3& point) {
    return dot(unit_normal(plane), point) <= plane.distance;
}

Box inside_bounds(const Plane& plane) {
    Box box = bounds(plane);
    const Vec3 normal = unit(plane.normal);
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] == 1) box.high[axis] = plane.distance;
        if (normal[axis] == -1) box.low[axis] = -plane.distance;
    }
    return box;
}

std::string problem(const Plane& plane) {
    const double size = length(plane.normal);
    return size > 0 && size < 1e150
               ? ""
               : "a `plane` needs a normal with a length above 0 and below 1e150";
}

}  // namespace candelabra
