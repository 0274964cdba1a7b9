// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/rectangle.h"

#include "luminaire/emit.h"
#include "luminaire/light_proxy.h"
#include "luminaire/seen_rectangle.h"
#include "luminaire/triangle.h"

#include <cmath>
#include <limits>

namespace candelabra {

namespace {

SeenRectangle seen(const RectangleEmitter& r, const Receiver& point) {
    const bool one_side = point.horizon == Horizon::one_side;
    return {r.corner, r.side1, r.side2, point.position, one_side ? &point.normal : nullptr};
}

}  // namespace

LightBounds bounds(const RectangleEmitter& r, double luminance) {
    Box box{r.corner, r.corner};
    for (const Vec3& side : {r.side1, r.side2, r.side1 + r.side2}) box = join(box, r.corner + side);
    const Vec3 scaled_normal = cross(r.side1, r.side2);
    // The centre is rounded, but the sphere must still contain the rectangle.
    const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                            std::fmax(max_abs_component(box.low), max_abs_component(box.high));
    return {box,
            r.corner + 0.5 * (r.side1 + r.side2),
            length(r.side1 + r.side2) / 2 * (1 + 1e-12) + rounding,
            unit(scaled_normal),
            luminance * length(scaled_normal),
            luminance};
}

double unoccluded(const RectangleEmitter& r, double luminance, const Receiver& point) {
    // The bounding spheres of its halves reach farther than its own.
    if (irradiance(light_proxy(bounds(r, luminance)), point) == 0) return 0;
    const Vec3 opposite = r.corner + r.side1 + r.side2;
    return unoccluded(TriangleEmitter{r.corner, r.corner + r.side1, opposite}, luminance, point) +
           unoccluded(TriangleEmitter{r.corner, opposite, r.corner + r.side2}, luminance, point);
}

std::optional<LightPoint> sample(const RectangleEmitter& r, const Receiver& point, const Vec2& u) {
    const SeenRectangle part = seen(r, point);
    return part.weight() > 0 ? part.draw(u) : std::nullopt;
}

std::optional<LightPoint> sample(const RectangleEmitter& r, const Vec3& from, const Vec2& u) {
    return sample(r, Receiver{from, Vec3(0), Horizon::none}, u);
}

void intersect(const RectangleEmitter& r, const Receiver& point, const Vec3& direction,
               LightHits& met) {
    const Vec3 normal = cross(r.side1, r.side2), to_corner = r.corner - point.position;
    const double distance = dot(to_corner, normal) / dot(direction, normal);
    if (!(distance > 0 && distance < std::numeric_limits<double>::infinity())) return;
    const Vec3 on = distance * direction - to_corner;
    const double along1 = dot(on, r.side1) / dot(r.side1, r.side1),
                 along2 = dot(on, r.side2) / dot(r.side2, r.side2);
    if (!(along1 >= 0 && along1 <= 1 && along2 >= 0 && along2 <= 1)) return;
    const double density = seen(r, point).density(direction, distance);
    if (density > 0) met.push_back({distance, density});
}

std::optional<EmittedRay> emit(const RectangleEmitter& r, double, const EmissionDraw& u) {
    const double area = emitting_area(r);
    if (!(area > 0)) return {};
    return emitted_ray(r.corner + u.where.x * r.side1 + u.where.y * r.side2,
                       unit(cross(r.side1, r.side2)), 1 / area, 0.5, u);
}

double emitting_area(const RectangleEmitter& r) { return length(cross(r.side1, r.side2)); }

}  // namespace candelabra
