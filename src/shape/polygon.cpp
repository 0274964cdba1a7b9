// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/polygon.h"

#include "vocabulary/schema.h"

#include <tuple>

namespace candelabra {

const ItemInfo Polygon::vocabulary = described<Polygon>([] {
    using F = Field<Polygon>;
    return schema<Polygon>(
        "polygon",
        {"A flat area between straight edges.",
         "polygon { 6, <0, 1.8>, <1, 1.1>, <0.6, 0.1>, <-0.6, 0.1>, <-1, 1.1>, <0, 1.8> }"},
        F{"points", &Polygon::points, counted,
          "corners, loop after loop; each loop ends with its first corner"});
});

namespace {

Box box_of(const Polygon& polygon) {
    Box box;
    for (const Vec3& p : polygon.points) box = join(box, p);
    return box;
}

/// Unit normal of the plane, from the first edge and the first corner not collinear with it; 0 when
/// there is none.
Vec3 plane_normal(const Polygon& polygon) {
    const auto& p = polygon.points;
    const double size = length(box_of(polygon).size());
    Vec3 edge(0);
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vec3 to = p[i] - p[0];
        if (length(to) <= 1e-10 * size) continue;
        if (edge == Vec3(0)) edge = to;
        const Vec3 normal = cross(edge, to);
        if (length(normal) > 1e-10 * length(edge) * length(to)) return unit(normal);
    }
    return Vec3(0);
}

/// Rounding of a side, as a fraction of it.
constexpr double side_rounding = 1e-9;

std::optional<FlatRectangle> rectangle_of(const Polygon& polygon) {
    const auto& p = polygon.points;
    if (p.size() != 4 && !(p.size() == 5 && p[4] == p[0])) return {};
    const Vec3 side1 = p[1] - p[0], side2 = p[3] - p[0];
    const double size = length(side1) + length(side2);
    const bool opposite = length(p[2] - p[0] - side1 - side2) <= side_rounding * size;
    return opposite && at_right_angles(side1, side2)
               ? std::optional(FlatRectangle{p[0], side1, side2})
               : std::nullopt;
}

}  // namespace

bool at_right_angles(const Vec3& side1, const Vec3& side2) {
    return std::abs(dot(side1, side2)) <= side_rounding * length(side1) * length(side2);
}

BuiltPolygon build(const Polygon& polygon) {
    BuiltPolygon result;
    result.bounds = box_of(polygon);
    result.rectangle = rectangle_of(polygon);
    result.origin = polygon.points.front();
    result.normal = plane_normal(polygon);
    std::tie(result.right, result.up) = perpendiculars(result.normal);
    std::vector<Vec2> flat;
    for (const Vec3& p : polygon.points)
        flat.emplace_back(dot(p - result.origin, result.right), dot(p - result.origin, result.up));
    result.outline = Outline(closed_curves(linear_curve, flat).loops);
    return result;
}

std::string problem(const Polygon& polygon) {
    if (polygon.points.size() < 3) return "a `polygon` needs at least 3 corners";
    const Vec3 normal = plane_normal(polygon);
    if (normal == Vec3(0)) return "a `polygon` needs three corners that are not on one line";
    const Box box = box_of(polygon);
    const double size = max_abs_component(box.low) + max_abs_component(box.high);
    for (const Vec3& p : polygon.points)
        if (std::abs(dot(p - polygon.points.front(), normal)) > 1e-6 * size)
            return "the corners of a `polygon` must lie in one plane";
    return {};
}

Box bounds(const BuiltPolygon& polygon) { return polygon.bounds; }

void crossings(const BuiltPolygon& polygon, const Ray& ray, Crossings& found) {
    const double approach = dot(ray.direction, polygon.normal);
    if (approach == 0) return;
    const Vec3 offset = ray.origin - polygon.origin;
    const double t = -dot(offset, polygon.normal) / approach;
    const Vec3 hit = offset + t * ray.direction;
    if (polygon.outline.contains({dot(hit, polygon.right), dot(hit, polygon.up)}))
        found.add({t, polygon.normal, approach < 0});
}

bool inside(const BuiltPolygon&, const Vec3&) { return false; }

}  // namespace candelabra
