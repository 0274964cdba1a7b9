// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/triangle.h"

#include "base/elementary.h"
#include "luminaire/emit.h"
#include "luminaire/light_proxy.h"
#include "shape/triangle.h"

#include <array>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Outside these solid angles the triangle is sampled by its area. A small triangle looks the same
/// all over, and the angles of its spherical triangle lose their digits; a huge one is as good as a
/// plane through the point.
constexpr double min_solid_angle = 3e-4, greatest_solid_angle = 6.22;
/// Ratio of radius to distance below which the irradiance is that of a small patch, then correct to
/// six digits.
constexpr double small = 1e-3;

/// The triangle as seen from a point.
struct TriangleView {
    TriangleView(const TriangleEmitter& t, const Vec3& from)
        : corners{t.corner1 - from, t.corner2 - from, t.corner3 - from},
          edge1(t.corner2 - t.corner1),
          edge2(t.corner3 - t.corner1),
          scaled_normal(cross(edge1, edge2)) {}

    /// Formula of van Oosterom and Strackee (1983), with the edges in the triple product so that
    /// distant triangles keep their digits.
    double solid_angle() const {
        const auto& [a, b, c] = corners;
        const double la = length(a), lb = length(b), lc = length(c);
        const double volume = std::abs(dot(a, scaled_normal));
        if (!(volume > 0)) return 0;
        return 2 *
               math::atan2(volume, la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }

    std::array<Vec3, 3> corners;  ///< relative to the point
    Vec3 edge1, edge2;
    Vec3 scaled_normal;  ///< twice the area long
};

/// The solid angle if the triangle is sampled by it, else 0.
double sampled_solid_angle(const TriangleView& view) {
    const double solid_angle = view.solid_angle();
    return solid_angle > min_solid_angle && solid_angle < greatest_solid_angle ? solid_angle : 0;
}

double area_density(const TriangleView& view, const Vec3& direction, double distance) {
    const double twice_seen = std::abs(dot(view.scaled_normal, direction));
    return twice_seen > 0 ? 2 * distance * distance / twice_seen : 0;
}

/// The part of v perpendicular to the unit vector u, normalised.
Vec3 away(const Vec3& v, const Vec3& u) { return unit(v - dot(v, u) * u); }

/// Angle between the planes through u that contain v and w.
double angle_at(const Vec3& u, const Vec3& v, const Vec3& w) {
    const Vec3 a = cross(u, v), b = cross(u, w);
    return math::atan2(length(cross(a, b)), dot(a, b));
}

/// Returns a direction in the triangle, uniform in solid angle (Arvo 1995): u.x cuts off part of
/// the triangle by a new corner on the third edge, and u.y chooses a point on the arc from the
/// second corner to the new one.
Vec3 direction_in(const TriangleView& view, double solid_angle, const Vec2& u) {
    const Vec3 a = unit(view.corners[0]), b = unit(view.corners[1]), c = unit(view.corners[2]);
    const double alpha = angle_at(a, b, c);
    const auto [sin_alpha, cos_alpha] = math::sin_cos(alpha);
    const auto [s, t] = math::sin_cos(u.x * solid_angle - alpha);
    const double p = t - cos_alpha, q = s + sin_alpha * dot(a, b);
    const double bottom = (q * s + p * t) * sin_alpha;
    const double cosine =
        bottom == 0 ? 1 : glm::clamp(((q * t - p * s) * cos_alpha - q) / bottom, -1.0, 1.0);
    const Vec3 corner = cosine * a + std::sqrt((1 - cosine) * (1 + cosine)) * away(c, a);
    const double versine = u.y * (1 - dot(corner, b));
    return (1 - versine) * b + std::sqrt(versine * (2 - versine)) * away(corner, b);
}

/// Where the direction meets the triangle's plane, relative to the point; moved into the triangle
/// if rounding put it outside.
Vec3 on_triangle(const TriangleView& view, const Vec3& direction) {
    const Vec3 p = cross(direction, view.edge2);
    const double determinant = dot(view.edge1, p);
    if (determinant == 0) return view.corners[0];
    const Vec3 to_origin = -view.corners[0];
    double v = glm::clamp(dot(to_origin, p) / determinant, 0.0, 1.0);
    double w = glm::clamp(dot(direction, cross(to_origin, view.edge1)) / determinant, 0.0, 1.0);
    const double sum = v + w;
    if (sum > 1) {
        v /= sum;
        w /= sum;
    }
    return view.corners[0] + v * view.edge1 + w * view.edge2;
}

/// A triangle clipped by the horizon: at most four corners.
struct Polygon {
    std::array<Vec3, 4> corners;
    std::size_t count = 0;

    void add(const Vec3& corner) { corners[count++] = corner; }
    const Vec3& next(std::size_t i) const { return corners[i + 1 < count ? i + 1 : 0]; }
};

Polygon above_horizon(const std::array<Vec3, 3>& corners, const Vec3& normal) {
    Polygon result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = corners[i], &to = corners[(i + 1) % 3];
        const double height = dot(normal, from), next = dot(normal, to);
        if (height >= 0) result.add(from);
        if ((height > 0 && next < 0) || (height < 0 && next > 0))
            result.add(from + height / (height - next) * (to - from));
    }
    return result;
}

/// Lambert's formula: the sum over the edges of their angle times the cosine between the receiver's
/// normal and that of the plane through edge and point.
double polygon_irradiance(const Polygon& polygon, const Vec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3 &from = polygon.corners[i], &to = polygon.next(i);
        const Vec3 across = cross(from, to);
        const double size = length(across);
        if (size > 0) sum += math::atan2(size, dot(from, to)) * dot(normal, across) / size;
    }
    return std::abs(sum) / 2;
}

/// The same for a small distant polygon, for which Lambert's formula would lose its digits.
double patch_irradiance(const Polygon& polygon, const Vec3& normal) {
    double result = 0;
    for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
        const Vec3 &a = polygon.corners[0], &b = polygon.corners[i], &c = polygon.corners[i + 1];
        const Vec3 middle = (a + b + c) / 3.0;
        const double d2 = dot(middle, middle);
        result += std::abs(dot(cross(b - a, c - a), middle)) / 2 * dot(normal, middle) / (d2 * d2);
    }
    return result;
}

double one_side(const TriangleView& view, const Vec3& normal, bool far) {
    const Polygon visible = above_horizon(view.corners, normal);
    return far ? patch_irradiance(visible, normal) : polygon_irradiance(visible, normal);
}

}  // namespace

LightBounds bounds(const TriangleEmitter& t, double luminance) {
    const Box box = join(join(Box{t.corner1, t.corner1}, t.corner2), t.corner3);
    const Vec3 scaled_normal = cross(t.corner2 - t.corner1, t.corner3 - t.corner1);
    const Vec3 centre = (t.corner1 + t.corner2 + t.corner3) / 3.0;
    const double radius =
        std::fmax(length(t.corner1 - centre),
                  std::fmax(length(t.corner2 - centre), length(t.corner3 - centre)));
    // The centre is rounded, but the sphere must still contain the triangle.
    const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                            std::fmax(max_abs_component(box.low), max_abs_component(box.high));
    return {box,
            centre,
            radius * (1 + 1e-12) + rounding,
            unit(scaled_normal),
            luminance * length(scaled_normal) / 2,
            luminance};
}

double unoccluded(const TriangleEmitter& t, double luminance, const Receiver& point) {
    const LightBounds b = bounds(t, luminance);
    // The estimate keeps the result above 0 where the exact one is lost in rounding.
    const double estimate = irradiance(light_proxy(b), point);
    if (estimate == 0) return 0;
    const TriangleView view(t, point.position);
    const bool far = b.radius < small * length(b.centre - point.position);
    if (point.horizon == Horizon::none) {
        // Where the solid angle loses its digits, the estimate is as good.
        const double solid_angle = far ? 0 : sampled_solid_angle(view);
        return solid_angle > 0 ? luminance * solid_angle : estimate;
    }
    double exact = one_side(view, point.normal, far);
    if (point.horizon == Horizon::both_sides) exact += one_side(view, -point.normal, far);
    return std::fmax(luminance * exact, 1e-4 * estimate);
}

std::optional<LightPoint> sample(const TriangleEmitter& t, const Vec3& from, const Vec2& u) {
    const TriangleView view(t, from);
    const double solid_angle = sampled_solid_angle(view);
    const double root = std::sqrt(u.x);
    const Vec3 offset = solid_angle > 0
                            ? on_triangle(view, direction_in(view, solid_angle, u))
                            : view.corners[0] + root * ((1 - u.y) * view.edge1 + u.y * view.edge2);
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    const Vec3 direction = offset / distance;
    const double density =
        solid_angle > 0 ? 1 / solid_angle : area_density(view, direction, distance);
    if (!(density > 0)) return {};
    return LightPoint{from + offset, direction, distance, density};
}

void intersect(const TriangleEmitter& t, const Receiver& point, const Vec3& direction,
               LightHits& met) {
    const TriangleHit hit =
        first_crossing(t.corner1, t.corner2, t.corner3, {point.position, direction}, {});
    if (!(hit.t < std::numeric_limits<double>::infinity())) return;
    const TriangleView view(t, point.position);
    const double solid_angle = sampled_solid_angle(view);
    met.push_back(
        {hit.t, solid_angle > 0 ? 1 / solid_angle : area_density(view, direction, hit.t)});
}

std::optional<EmittedRay> emit(const TriangleEmitter& t, double inner, const EmissionDraw& u) {
    const double area = emitting_area(t), root = std::sqrt(u.where.x);
    if (!(area > 0)) return {};
    const Vec3 edge1 = t.corner2 - t.corner1, edge2 = t.corner3 - t.corner1;
    const Vec3 position = t.corner1 + root * ((1 - u.where.y) * edge1 + u.where.y * edge2);
    return emitted_ray(position, triangle_normal(t.corner1, t.corner2, t.corner3), 1 / area,
                       inner_share(t.sealed, inner), u);
}

double emitting_area(const TriangleEmitter& t) {
    return length(cross(t.corner2 - t.corner1, t.corner3 - t.corner1)) / 2;
}

}  // namespace candelabra
